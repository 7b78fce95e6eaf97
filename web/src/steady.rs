//! The browser's clocks and its frames.

use leptos::prelude::window;
use std::cell::RefCell;
use std::rc::Rc;
use wasm_bindgen::JsCast;
use wasm_bindgen::closure::Closure;
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(js_namespace = performance, js_name = now)]
    fn performance_now() -> f64;
}

/// Milliseconds of the browser's steady clock: nobody sets it.
#[must_use]
pub(crate) fn steady() -> f64 {
    performance_now()
}

/// Milliseconds of the clock on the wall; only to find out that the computer slept.
#[must_use]
pub(crate) fn wall_clock() -> f64 {
    js_sys::Date::now()
}

/// Does something before each picture that the browser paints, as long as the page lives.
pub(crate) fn each_frame(mut act: impl FnMut() + 'static) {
    type Frame = Closure<dyn FnMut()>;
    fn ask(frame: &Frame) {
        // A page that has a window has frames.
        let _asked = window().request_animation_frame(frame.as_ref().unchecked_ref());
    }
    let kept: Rc<RefCell<Option<Frame>>> = Rc::default();
    let again = kept.clone();
    let frame = Frame::new(move || {
        act();
        if let Some(frame) = again.borrow().as_ref() {
            ask(frame);
        }
    });
    ask(&frame);
    // The two hold each other.
    kept.replace(Some(frame));
}
