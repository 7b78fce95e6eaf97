//! `docs/alerts.md`, `docs/sentences.md` and `docs/modes.md` are what the code says. `WHEELOVER_REWRITE=1` writes it anew.

use std::fs;
use std::path::PathBuf;
use wheelover_core::alerts;
use wheelover_core::autopilot::modes_document;
use wheelover_core::nmea::{dictionary, document};

#[test]
fn the_document_of_the_sentences_is_up_to_date() {
    is_up_to_date("sentences.md", &document());
}

#[test]
fn the_document_of_the_modes_is_up_to_date() {
    is_up_to_date("modes.md", &modes_document());
}

#[test]
fn the_document_of_the_alerts_is_up_to_date() {
    is_up_to_date("alerts.md", &alerts::document());
}

fn is_up_to_date(name: &str, document: &str) {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("../docs")
        .join(name);
    if std::env::var_os("WHEELOVER_REWRITE").is_some() {
        fs::write(&path, document).expect("the document is written");
    }
    let written = fs::read_to_string(&path).unwrap_or_default();
    assert!(
        written == document,
        "docs/{name} is not what the code says; WHEELOVER_REWRITE=1 writes it"
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

#[test]
fn every_formatter_of_the_edition_of_2024_is_in_the_dictionary() {
    let wanted = "AAM ABK ABM ACA ACK ACN ACS AGL AIR AKD ALA ALC ALF ALR APB ARC BBM BEC BOD BWC BWR BWW CUR DBT DDC \
        DOR DPT DSC DSE DTM EPM EPV ETL EVE FIR FSI GBS GDC GEN GFA GGA GLL GNS GRS GSA GST GSV HBT HCR HDG \
        HDT HMR HMS HRM HSC HSS HTC HTD LR1 LR2 LR3 LRF LRI MOB MSK MSS MTW MWD MWV NAK NLS NRM NRX NSR OSD \
        POS PRC RLM RMA RMB RMC ROR ROT RPM RRT RSA RSD RTE SEL SFI SLM SM1 SM2 SM3 SM4 SMB SMV SPW SSD STN \
        THS TLB TLL TRC TRD TRL TTD TTM TUT TXT UID VBC VBW VDM VDO VDR VER VHW VLW VPW VSD VTG WAT WCV WNC \
        WPL XDR XTE XTR ZDA ZDL ZFO ZTG";
    let missing: Vec<&str> = wanted
        .split_whitespace()
        .filter(|formatter| !dictionary().iter().any(|d| d.formatter == *formatter))
        .collect();
    assert_eq!(missing, [""; 0]);
    assert_eq!(wanted.split_whitespace().count(), 133);
}

#[test]
fn no_page_of_a_maker_reads_like_a_requirement() {
    // Furuno numbers the pages of its list as our requirements of the autopilot are numbered.
    let document = document();
    let cited: Vec<&str> = document.lines().filter(|l| l.contains("AP-")).collect();
    assert_eq!(cited, [""; 0]);
    assert!(document.contains("Furuno appendix p. 13"));
}
