//! The traits of functions that differ only in names and arguments, a line each.

use crate::place::is_same;

/// True if this is what a compiler is to say where a module lacks the function.
pub(super) const fn is_missing(message: &str, function: &str) -> bool {
    const BEFORE: &str = "`{Self}` was generated without `";
    const AFTER: &str = "`; name it in `functions`, alone and not in a sum, and generate again";
    let (rest, name) = (message.as_bytes(), function.as_bytes());
    let Some((before, rest)) = rest.split_at_checked(BEFORE.len()) else {
        return false;
    };
    let Some((middle, after)) = rest.split_at_checked(name.len()) else {
        return false;
    };
    is_same(before, BEFORE.as_bytes()) && is_same(middle, name) && is_same(after, AFTER.as_bytes())
}

/// One trait per line: its meaning, what a compiler says where it is missing, its name, its method. The method's doc refers to the
/// trait's, so that the meaning is written once. An attribute takes no text made of parts: the message is written out, and checked.
macro_rules! function_traits {
    ($($(#[$meaning:meta])* $missing:literal $name:ident: $method:ident($($argument:ident: $type:ty),+);)+) => {$(
        $(#[$meaning])*
        #[diagnostic::on_unimplemented(message = $missing)]
        pub trait $name<R: Real>: System<R> {
            #[doc = concat!("Overwrites the last argument; meaning, frame and unit are those of [`", stringify!($name), "`].")]
            fn $method(&self, $($argument: $type),+);
        }
        const _: () = assert!(
            $crate::functions::define::is_missing($missing, stringify!($method)),
            "the message names another function"
        );
    )+};
}

/// Like `function_traits`, for partial velocities: the compact columns and the pattern that places them.
macro_rules! partial_traits {
    ($($(#[$meaning:meta])* $missing:literal $name:ident: $method:ident($($argument:ident: $type:ty),+), $columns:ident, $blocks:ident;)+) => {$(
        $(#[$meaning])*
        #[diagnostic::on_unimplemented(message = $missing)]
        pub trait $name<R: Real>: System<R> {
            /// `[[R; 3]; n]`: the columns of the blocks that are not structurally zero, block after block.
            type $columns: Array<[R; 3]>;
            /// The place of each block, ordered by body, within a body by partition.
            const $blocks: &'static [Block];
            #[doc = concat!("Overwrites `columns`; meaning, frame and unit are those of [`", stringify!($name), "`].")]
            fn $method(&self, $($argument: $type,)+ columns: &mut Self::$columns);
        }
        const _: () = assert!(
            $crate::functions::define::is_missing($missing, stringify!($method)),
            "the message names another function"
        );
    )+};
}

/// Like `function_traits`, for derivatives: of which trait it is one more, and what the method overwrites. The tests of requests check that
/// the message names the request.
macro_rules! derivative_traits {
    ($($(#[$meaning:meta])* $missing:literal $name:ident of $base:ident: $method:ident($($argument:ident: $type:ty),+), $overwritten:literal;)+) => {$(
        $(#[$meaning])*
        #[diagnostic::on_unimplemented(message = $missing)]
        pub trait $name<R: Real>: $base<R> {
            #[doc = concat!("Overwrites ", $overwritten, "; meaning and units are those of [`", stringify!($name), "`].")]
            #[allow(clippy::too_many_arguments, reason = "the generated function's own")]
            fn $method(&self, $($argument: $type),+);
        }
    )+};
}
