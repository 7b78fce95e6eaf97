//! `docs/sentences.md` is what the tables say. `WHEELOVER_REWRITE=1` writes it anew.

use std::fs;
use std::path::PathBuf;
use wheelover_core::nmea::{dictionary, explain};

#[test]
fn the_document_of_the_sentences_is_up_to_date() {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../docs/sentences.md");
    let document = explain::document();
    if std::env::var_os("WHEELOVER_REWRITE").is_some() {
        fs::write(&path, &document).expect("the document is written");
    }
    let written = fs::read_to_string(&path).unwrap_or_default();
    assert!(
        written == document,
        "docs/sentences.md is not what the tables say; WHEELOVER_REWRITE=1 writes it"
    );
}

#[test]
fn every_sentence_of_the_four_documents_is_in_the_dictionary() {
    let wanted = "HTC HTD XTE APB BWC BWR HSC VTG GGA GLL VHW VBW HDT THS HDG HDM ROT RSA ROR HMS HMR ALR ALA \
        PNEY,001 PNEY,002 ABM ACK ALC ALF ARC BBM EVE HBT MTW MWV OSD RMC RSD TLB TTD TTM VDM VDO VDR VSD ZDA \
        MWD VWR XDR BOD RMB WPL RTE VLW HRM ACN PEMC,00 PEMC,01 PEMC,02 PEMC,03 PEMC,04 PEMC,05 PEMC,06 PEMC,07 \
        PEMC,08 PEMC,09 PEMC,10 PEMC,11 PEMC,12 PEMC,13 PEMC,14 PEMC,99";
    for formatter in wanted.split_whitespace() {
        assert!(
            dictionary().iter().any(|d| d.formatter == formatter),
            "{formatter}"
        );
    }
}
