//! The plan view: own ship to scale, the route, the turn and the radius centre, drawn as SVG without any library (DSP-4).

pub mod frame;
pub mod shapes;

#[cfg(target_arch = "wasm32")]
mod ship;
#[cfg(target_arch = "wasm32")]
mod track;
#[cfg(target_arch = "wasm32")]
mod view;

#[cfg(target_arch = "wasm32")]
pub(crate) use view::Plan;
