// SPDX-License-Identifier: MIT
//! Plays the first clip of a .sinew file in five steps and prints where the first joint is.
use std::process::ExitCode;

fn play(file: &str) -> Result<(), String> {
    if unsafe { sinew_sys::sinew_version() } != sinew_sys::VERSION {
        return Err("the library is not that of the declarations".into());
    }
    let bytes = std::fs::read(file).map_err(|error| format!("{file}: {error}"))?;
    let scene = sinew_sys::Scene::read(&bytes).map_err(|error| format!("{file}: {error}"))?;
    for step in 0..=4 {
        let time_s = scene.clip_duration_s(0) * f64::from(step) / 4.0;
        let model = scene.world_matrices(0, time_s)?;
        let [x, y, z] = model[0].row;
        println!("{time_s:.2} s: first joint at {:.3} {:.3} {:.3} m", x[3], y[3], z[3]);
    }
    Ok(())
}

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().collect();
    let [_, file] = words.as_slice() else {
        eprintln!("usage: sinew-sys FILE.sinew");
        return ExitCode::from(2);
    };
    match play(file) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}
