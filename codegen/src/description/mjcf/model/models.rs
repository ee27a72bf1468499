//! A model with those that it attaches, and those that these attach.

use std::collections::{BTreeMap, BTreeSet};

use crate::description::mjcf::files::{Files, include::is_model};
use crate::description::mjcf::model::copies::Copies;
use crate::description::mjcf::model::{Beside, Model, ModelAsset};
use crate::description::xml::{Element, Reader};
use crate::diagnostic::{Diagnostic, Spanned, shown};

/// The name of a model that has none, as MuJoCo calls it.
const NAME: &str = "MuJoCo Model";

/// The main model, number 0, and those that are attached, directly or by others. No model attaches itself.
#[derive(Debug)]
pub(in crate::description::mjcf) struct Models<'d> {
    pub(in crate::description::mjcf) list: Vec<Model<'d>>,
    /// How many elements `replicate` and `attach` copied.
    pub(in crate::description::mjcf) copies: Copies,
}

impl<'d> Models<'d> {
    /// Reads all models; `None` where the root is none, or where a model is an asset of itself.
    pub(in crate::description::mjcf) fn read(
        reader: &mut Reader,
        files: &'d Files<'d>,
        root: Element<'d>,
        beside: Beside<'d>,
    ) -> Option<Self> {
        if !accept(reader, root) {
            return None;
        }
        let mut list = vec![Model::read(reader, files, root, None, beside)];
        // By the number of the file; the main file is read anew where it is an asset, which is refused below.
        let mut numbers = BTreeMap::new();
        let mut index = 0;
        while let Some(model) = list.get(index) {
            let assets = model.named("asset");
            let elements = assets.into_iter().flat_map(|asset| files.children(asset));
            for element in elements.filter(|element| element.name() == "model") {
                // What is wrong with its file was said as that was loaded.
                let Some((file, root)) = files.named(element) else {
                    continue;
                };
                let number = *numbers.entry(file).or_insert(list.len());
                if number == list.len() {
                    if !accept(reader, root) {
                        return None;
                    }
                    let main = Some(&list[0].settings);
                    list.push(Model::read(reader, files, root, main, beside));
                }
                let name = element.attribute("name").or(root.attribute("model"));
                let name = name.map_or(NAME, |name| name.value);
                let assets = &mut list[index].assets;
                if assets.contains_key(name) {
                    let message = format!(
                        "model `{}` is given twice; the first one counts",
                        shown(name)
                    );
                    let fault = Diagnostic::warning(message).at(element.span(), "ignored");
                    reader.faults.push(fault);
                } else {
                    let place = element.span();
                    assets.insert(name, ModelAsset { number, place });
                }
            }
            index += 1;
        }
        let models = Self {
            list,
            copies: Copies::default(),
        };
        models.attaches_none_to_itself(reader).then_some(models)
    }

    /// The main model.
    pub(in crate::description::mjcf) fn main(&self) -> &Model<'d> {
        &self.list[0]
    }

    /// Refuses an asset that leads back to the model whose asset it is.
    fn attaches_none_to_itself(&self, reader: &mut Reader) -> bool {
        let models = self.list.iter().enumerate();
        let mut assets =
            models.flat_map(|(owner, model)| model.assets.values().map(move |own| (owner, own)));
        let circular = assets.find(|(owner, own)| self.reached(own.number).contains(owner));
        if let Some((_, asset)) = circular {
            let message = "a model is an asset of itself, directly or by another one";
            let fault = Diagnostic::error(message).at(asset.place, "one of the assets");
            reader.faults.push(fault);
        }
        circular.is_none()
    }

    /// A model and all among its assets, and among theirs.
    fn reached(&self, number: usize) -> BTreeSet<usize> {
        let mut reached = BTreeSet::from([number]);
        let mut open = vec![number];
        while let Some(model) = open.pop() {
            let assets = self.list[model].assets.values();
            open.extend(
                assets
                    .map(|asset| asset.number)
                    .filter(|asset| reached.insert(*asset)),
            );
        }
        reached
    }
}

/// The name of the model with this root.
pub(in crate::description::mjcf) fn name(root: Element<'_>) -> Spanned<String> {
    match root.attribute("model") {
        Some(name) => Spanned::new(name.value.to_owned(), name.span),
        None => Spanned::new(NAME.to_owned(), root.span()),
    }
}

/// Refuses a root that is no model.
fn accept(reader: &mut Reader, root: Element<'_>) -> bool {
    let is_model = is_model(root);
    if !is_model {
        let found = shown(root.name());
        let fault = format!("the root element is `{found}`; expected `mujoco`");
        let fault = Diagnostic::error(fault).at(root.span(), "expected `mujoco`");
        let help =
            "a URDF has the root element `robot`; convert other formats to one of the two first";
        reader.faults.push(fault.help(help));
    }
    is_model
}
