// SPDX-License-Identifier: MIT
//! Finds the installed library by pkg-config: set PKG_CONFIG_PATH where it lies elsewhere than in the system.
use std::process::Command;

fn main() {
    println!("cargo:rerun-if-env-changed=PKG_CONFIG_PATH");
    let output = Command::new("pkg-config")
        .args(["--libs", "sinew-c_assets"])
        .output()
        .expect("pkg-config is needed");
    if !output.status.success() {
        panic!("{}", String::from_utf8_lossy(&output.stderr));
    }
    // Static libraries name each other in order, which cargo keeps as it does the group.
    for word in String::from_utf8(output.stdout).unwrap().split_whitespace() {
        if let Some(folder) = word.strip_prefix("-L") {
            println!("cargo:rustc-link-search=native={folder}");
        } else {
            println!("cargo:rustc-link-arg={word}");
        }
    }
    println!("cargo:rustc-link-arg=-lstdc++");
}
