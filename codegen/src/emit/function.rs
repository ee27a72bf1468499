//! One function: documentation, signature, statements, stores, and the trait that holds it.

use std::collections::BTreeSet;

use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, quote};

use super::{
    Emittable, allow_generated, allow_unused, doc,
    expression::{self, Writer},
    ident,
};
use crate::{
    functions::{Argument, Function, Shape},
    program::{self, Groups, Instruction, Operand, Origin, Program, ValueId},
    tree::Tree,
};

/// The items of one function, in order: its pattern, itself, its trait.
pub(super) fn items(tree: &Tree, emittable: &Emittable, fields: &[String]) -> Vec<TokenStream> {
    let function = emittable.function;
    let mut items = pattern(emittable);
    items.push(free_function(tree, emittable, fields));
    items.extend(function.trait_name.map(|name| trait_impl(function, name)));
    items
}

/// The statements of a program whose inputs are arguments: bindings, computations.
pub(super) fn statements(
    program: &Program,
    groups: &Groups,
    names: &[String],
    parameters: &[String],
) -> Vec<TokenStream> {
    let writer = Writer {
        program,
        groups,
        names,
    };
    let mut body = Body {
        writer,
        parameters,
        bound: BTreeSet::new(),
        statements: Vec::new(),
    };
    for instruction in &program.instructions {
        body.instruction(instruction);
    }
    for id in program.stores.iter().filter_map(|store| store.value()) {
        let mut inputs = Vec::new();
        body.writer.input_of(id, &mut inputs);
        body.bind(inputs);
    }
    body.statements
}

struct Body<'a> {
    writer: Writer<'a>,
    parameters: &'a [String],
    bound: BTreeSet<ValueId>,
    statements: Vec<TokenStream>,
}

impl Body<'_> {
    fn instruction(&mut self, instruction: &Instruction) {
        let mut inputs = Vec::new();
        match instruction {
            Instruction::Compute { result, operation } => {
                if self.writer.groups.inlined(*result).is_some() {
                    return;
                }
                self.writer.inputs_of(*operation, &mut inputs);
                self.bind(inputs);
                let (name, value) = (self.name(*result), self.writer.operation(*operation));
                self.statements.push(quote!(let #name = #value;));
            }
            Instruction::SinCos {
                angles,
                sines,
                cosines,
            } => {
                for id in angles.iter().filter_map(|angle| angle.value()) {
                    self.writer.input_of(id, &mut inputs);
                }
                self.bind(inputs);
                let angles: Vec<_> = angles
                    .iter()
                    .map(|&angle| self.writer.operand(angle))
                    .collect();
                let names = |ids: &[Option<ValueId>]| {
                    ids.iter().map(|&id| self.pattern(id)).collect::<Vec<_>>()
                };
                let (sines, cosines) = (names(sines), names(cosines));
                if let ([angle], [sine], [cosine]) = (&angles[..], &sines[..], &cosines[..]) {
                    self.statements
                        .push(quote!(let (#sine, #cosine) = R::sin_cos(#angle);));
                } else {
                    // Three short lines: a pattern of two lists is printed over a dozen.
                    self.statements
                        .push(quote!(let (sines, cosines) = R::sin_cos_array([#(#angles),*]);));
                    self.statements.push(quote!(let [#(#sines),*] = sines;));
                    self.statements.push(quote!(let [#(#cosines),*] = cosines;));
                }
            }
        }
    }

    /// Reads inputs into locals, each where it is first needed.
    fn bind(&mut self, inputs: Vec<ValueId>) {
        for id in inputs {
            if let Origin::Input(input) = self.writer.program.value(id).origin
                && self.bound.insert(id)
            {
                let (name, value) = (self.name(id), expression::input(input, self.parameters));
                self.statements.push(quote!(let #name = #value;));
            }
        }
    }

    fn name(&self, id: ValueId) -> proc_macro2::Ident {
        ident(&self.writer.names[id.index()])
    }

    fn pattern(&self, id: Option<ValueId>) -> TokenStream {
        id.map_or(quote!(_), |id| self.name(id).into_token_stream())
    }
}

fn free_function(tree: &Tree, emittable: &Emittable, fields: &[String]) -> TokenStream {
    let Emittable {
        function,
        program,
        formulation,
        operations,
        ..
    } = emittable;
    let groups = Groups::of(program);
    let names = program::names(program, &groups, tree, fields);
    let statements = statements(program, &groups, &names, &[]);
    let writer = Writer {
        program,
        groups: &groups,
        names: &names,
    };
    let n_columns = program.stores.len() / 3;
    let lengths = function.shape.lengths(tree, n_columns);
    let output = ident(function.output);
    let stores = program
        .stores
        .iter()
        .enumerate()
        .map(|(place, &store): (usize, &Operand)| {
            let (target, value) = (target(&output, &lengths, place), writer.operand(store));
            quote!(#target = #value;)
        });
    let mut lines: Vec<String> = function.doc.iter().map(ToString::to_string).collect();
    lines.push(String::new());
    let how = if function.formulations().len() > 1 {
        format!("; formulation: {}", formulation.name())
    } else {
        String::new()
    };
    lines.push(format!("Operations: {operations}{how}."));
    let (doc, allow) = (doc(lines), allow_generated());
    let name = ident(function.name);
    let (arguments, output_type) = (arguments(function), output_type(function));
    quote! {
        #doc
        #allow
        #[inline(never)]
        pub fn #name<R: kane::Real>(p: &Prepared<R>, #(#arguments,)* #output: &mut #output_type) {
            #(#statements)*
            #(#stores)*
        }
    }
}

/// The place of an output's entry: `m[0][3]`.
fn target(output: &proc_macro2::Ident, lengths: &[usize], place: usize) -> TokenStream {
    if lengths.is_empty() {
        return quote!(*#output);
    }
    let mut rest = place;
    let mut indexes: Vec<usize> = lengths
        .iter()
        .rev()
        .map(|length| {
            let index = rest % length;
            rest /= length;
            index
        })
        .collect();
    indexes.reverse();
    let indexes = indexes.into_iter().map(Literal::usize_unsuffixed);
    quote!(#output #([#indexes])*)
}

fn arguments(function: &Function) -> Vec<TokenStream> {
    let argument = |argument: &Argument| {
        let name = ident(argument.name());
        match argument {
            Argument::Q => quote!(#name: &[R; NQ]),
            Argument::U | Argument::UDot | Argument::Tau => quote!(#name: &[R; NU]),
            Argument::Loads => quote!(#name: &[kane::Load<R>; NB]),
            Argument::RelativeAngularVelocity => quote!(#name: &[[R; 3]; NB]),
        }
    };
    function.arguments.iter().map(argument).collect()
}

fn output_type(function: &Function) -> TokenStream {
    match function.shape {
        Shape::Scalar => quote!(R),
        Shape::Vector => quote!([R; 3]),
        Shape::Coordinates => quote!([R; NQ]),
        Shape::Speeds => quote!([R; NU]),
        Shape::SpeedMatrix => quote!([[R; NU]; NU]),
        Shape::BodyScalars => quote!([R; NB]),
        Shape::BodyVectors => quote!([[R; 3]; NB]),
        Shape::BodyMatrices => quote!([[[R; 3]; 3]; NB]),
        Shape::Columns => {
            let columns = ident(&function.columns_constant());
            quote!([[R; 3]; #columns])
        }
    }
}

/// The pattern of a compact output, as constants.
fn pattern(emittable: &Emittable) -> Vec<TokenStream> {
    if emittable.function.shape != Shape::Columns {
        return Vec::new();
    }
    let name = emittable.function.name;
    let (columns, blocks) = (
        ident(&emittable.function.columns_constant()),
        ident(&emittable.function.blocks_constant()),
    );
    let n_columns = Literal::usize_unsuffixed(emittable.program.stores.len() / 3);
    let n_blocks = Literal::usize_unsuffixed(emittable.blocks.len());
    let entries = emittable.blocks.iter().map(|block| {
        let [body, partition, speed, columns, first] =
            [block.body, block.partition, block.speed, block.columns, block.first].map(Literal::usize_unsuffixed);
        quote!(kane::Block { body: #body, partition: #partition, speed: #speed, columns: #columns, first: #first })
    });
    let allow = allow_unused();
    let columns_doc = doc([format!("Number of columns that `{name}` writes.")]);
    let blocks_doc = doc([format!(
        "The non-zero partitions that `{name}` writes, body after body."
    )]);
    vec![
        quote!(#columns_doc #allow pub const #columns: usize = #n_columns;),
        quote!(#blocks_doc #allow pub const #blocks: [kane::Block; #n_blocks] = [#(#entries),*];),
    ]
}

/// The runtime crate's trait for the function.
fn trait_impl(function: &Function, trait_name: &str) -> TokenStream {
    let (trait_name, method, output) = (
        ident(trait_name),
        ident(function.name),
        ident(function.output),
    );
    let (arguments, output_type) = (arguments(function), output_type(function));
    let names = function
        .arguments
        .iter()
        .map(|argument| ident(argument.name()));
    let associated = match function.shape {
        Shape::SpeedMatrix => quote!(type Matrix = #output_type;),
        Shape::Columns => {
            let columns = ident(&format!(
                "{}Columns",
                function.trait_name.expect("compact functions have traits")
            ));
            let blocks = ident(&function.blocks_constant());
            quote! {
                type #columns = #output_type;
                const #blocks: &'static [kane::Block] = &#blocks;
            }
        }
        _ => quote!(),
    };
    quote! {
        impl<R: kane::Real> kane::functions::#trait_name<R> for Prepared<R> {
            #associated
            #[inline]
            fn #method(&self, #(#arguments,)* #output: &mut #output_type) {
                self::#method(self, #(#names,)* #output);
            }
        }
    }
}
