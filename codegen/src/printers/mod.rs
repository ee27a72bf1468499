//! Texts of a listing, a folder for each language.
//!
//! In: a [`listing::Module`](crate::listing::Module). Out: text. Afterwards: the text says what the listing says, in its order; operations
//! are associated as its expressions are. Does not: decide what is computed, read, stored or named.
//!
//! A printer for another language is a folder here, and a file beside the module is a [`companions::CompanionKind`](crate::companions::CompanionKind).
//! It writes four things: the [constants](crate::listing::Constant); the structures of parameters, prepared values, sines and
//! cosines; the declaration of each of [`Module::all`](crate::listing::Module::all), from its signature; its statements. Of its language
//! it has to know the words that it reserves: the listing's names are lower snake case, so a name with a capital is free.

pub mod c;
pub(crate) mod json;
pub(crate) mod rust;
