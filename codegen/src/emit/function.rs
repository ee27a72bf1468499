//! One function: documentation, signature, statements, stores, and the trait that holds it.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::{
    Emittable, allow_generated, allow_unused, doc,
    expression::Writer,
    ident,
    statements::{self, Stores},
};
use crate::{
    expr::Input,
    functions::{Argument, Function, Shape},
    program::{self, Groups, Origin, Place, Program, ValueId},
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

fn free_function(tree: &Tree, emittable: &Emittable, fields: &[String]) -> TokenStream {
    let Emittable {
        function,
        program,
        formulation,
        operations,
        ..
    } = emittable;
    let groups = Groups::of(program);
    let names = program::names(program, &groups, tree, Place::Function { fields });
    let n_columns = program.stores.len() / 3;
    let lengths = function.shape.lengths(tree, n_columns);
    let output = ident(function.output);
    let writer = Writer {
        program,
        groups: &groups,
        names: &names,
    };
    let mut stores = Stores::default();
    for (place, &store) in program.stores.iter().enumerate() {
        let (target, value) = (target(&output, &lengths, place), writer.operand(store));
        let statement = quote!(#target = #value;);
        match store.value().filter(|&id| !is_field(program, id)) {
            Some(id) => stores.of_values.entry(id).or_default().push(statement),
            None => stores.of_constants.push(statement),
        }
    }
    let statements = statements::of(program, &groups, &names, &[], stores);
    let mut lines: Vec<String> = function.doc.iter().map(ToString::to_string).collect();
    lines.push(String::new());
    let how = if function.formulations().len() > 1 {
        format!("; formulation: {}", formulation.name())
    } else {
        String::new()
    };
    lines.push(format!("Operations: {operations}{how}."));
    if program.fused() > 0 {
        let fused = program.fused();
        lines.push(format!(
            "Of the multiplications and additions {fused} each are fused."
        ));
    }
    let (doc, allow) = (doc(lines), allow_generated());
    let name = ident(function.name);
    let (arguments, output_type) = (arguments(function), output_type(function));
    quote! {
        #doc
        #allow
        #[inline(never)]
        pub fn #name<R: kane::Real>(p: &Prepared<R>, #(#arguments,)* #output: &mut #output_type) {
            #(#statements)*
        }
    }
}

/// True for a field of `Prepared`, which needs no statement before it is stored.
fn is_field(program: &Program, id: ValueId) -> bool {
    matches!(program.value(id).origin, Origin::Input(Input::Prepared(_)))
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
