//! An order of the officer's to a station, and its answer.

use wheelover_core::command::{Order, Origin};
use wheelover_core::station::{Input, Output};

/// Gives an order to `station`; what became of it.
pub(crate) fn ask(
    order: &Order,
    station: impl FnOnce(Input<'_>, &mut Vec<Output>),
) -> Result<String, String> {
    let by = Origin::Officer;
    let mut out = Vec::new();
    station(Input::Order { by, order }, &mut out);
    let mut answers = out.into_iter().filter_map(|output| match output {
        Output::Answer(answer) => Some(answer.map_err(|refusal| refusal.to_string())),
        _ => None,
    });
    answers.next_back().expect("every order is answered")
}
