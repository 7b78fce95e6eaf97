//! The plan view: own ship to scale, the route, the turn and the radius centre, drawn as SVG without any library (DSP-4).

mod foreign;
pub mod frame;
mod markup;
pub mod scene;
pub mod shapes;
mod ship;
mod track;

#[cfg(target_arch = "wasm32")]
mod view;

#[cfg(target_arch = "wasm32")]
pub(crate) use view::Plan;
