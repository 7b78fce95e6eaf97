//! Chromium with its console watched: values by `data-value`, buttons by `data-command`, never by a CSS class.

use fantoccini::wd::Capabilities;
use fantoccini::{Client, ClientBuilder, Locator};
use hyper_util::client::legacy::connect::HttpConnector;
use nix::sys::signal::{Signal, kill, killpg};
use nix::unistd::Pid;
use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::os::unix::process::CommandExt;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// A browser window; it ends with this value.
#[derive(Debug)]
pub struct Browser {
    /// The WebDriver client.
    pub client: Client,
    driver: Driver,
    session: String,
}

#[derive(Debug)]
struct Driver {
    child: Child,
    address: SocketAddr,
}

impl Drop for Driver {
    fn drop(&mut self) {
        // The whole group, so that a test that failed leaves no Chromium behind.
        if let Ok(id) = i32::try_from(self.child.id()) {
            let _ = killpg(Pid::from_raw(id), Signal::SIGKILL);
        }
        let _ = self.child.wait();
    }
}

impl Driver {
    #[allow(clippy::unwrap_used)]
    fn start() -> Self {
        let began = crate::alone();
        let mut child = Command::new("chromedriver")
            .arg("--port=0")
            .process_group(0)
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .unwrap_or_else(|error| {
                panic!("chromedriver: {error}; `cargo xtask test` installs it")
            });
        drop(began);
        let mut lines = BufReader::new(child.stdout.take().unwrap()).lines();
        let port = lines.by_ref().map_while(Result::ok).find_map(|line| {
            let rest = line.split("successfully on port ").nth(1)?;
            rest.trim_end_matches('.').parse::<u16>().ok()
        });
        std::thread::spawn(move || lines.for_each(drop));
        Self {
            child,
            address: ([127, 0, 0, 1], port.unwrap_or_default()).into(),
        }
    }
}

impl Browser {
    /// Opens an empty window of 1280 by 800.
    ///
    /// # Panics
    /// Chromium or its driver is missing.
    #[allow(clippy::unwrap_used)]
    pub async fn open() -> Self {
        let driver = Driver::start();
        let mut wanted = Capabilities::new();
        wanted.insert(
            "goog:chromeOptions".into(),
            json!({"args": [
                "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
                "--disable-background-networking", "--disable-component-update", "--disable-sync",
                "--disable-dev-shm-usage", "--window-size=1280,800", "--allow-file-access-from-files",
            ]}),
        );
        wanted.insert("goog:loggingPrefs".into(), json!({"browser": "ALL"}));
        wanted.insert(
            "timeouts".into(),
            json!({"pageLoad": 60_000, "script": 30_000}),
        );
        let client = ClientBuilder::new(HttpConnector::new())
            .capabilities(wanted)
            .connect(&format!("http://{}", driver.address))
            .await
            .unwrap();
        let session = client.session_id().await.unwrap().unwrap();
        Self {
            client,
            driver,
            session,
        }
    }

    /// Goes to an address.
    ///
    /// # Panics
    /// It cannot be loaded.
    #[allow(clippy::unwrap_used)]
    pub async fn go(&self, address: &str) {
        self.client.goto(address).await.unwrap();
        let source = self.client.source().await.unwrap();
        assert!(
            !source.contains("built without the page"),
            "this program was built without the page: unset WHEELOVER_BIN after `cargo xtask build`"
        );
    }

    /// Runs a script and gives what it returns.
    ///
    /// # Panics
    /// The script fails.
    #[allow(clippy::unwrap_used)]
    pub async fn run(&self, script: &str) -> Value {
        self.client.execute(script, vec![]).await.unwrap()
    }

    /// Text and state of a value; empty where it is not on the page.
    pub async fn value(&self, name: &str) -> (String, String) {
        let script = format!(
            "const e = document.querySelector('[data-value=\"{name}\"]'); \
             return e ? [e.innerText.trim(), e.dataset.state || ''] : ['', ''];"
        );
        let pair = self.run(&script).await;
        let text = |index: usize| pair[index].as_str().unwrap_or_default().to_string();
        (text(0), text(1))
    }

    /// State of an alert; empty where it is not shown.
    pub async fn alert(&self, number: u16) -> String {
        let script = format!(
            "const e = document.querySelector('[data-alert=\"{number}\"]'); \
             return e ? e.dataset.state || 'shown' : '';"
        );
        self.run(&script)
            .await
            .as_str()
            .unwrap_or_default()
            .to_string()
    }

    /// Clicks a button by its `data-command`.
    ///
    /// # Panics
    /// It is not there.
    #[allow(clippy::unwrap_used)]
    pub async fn press(&self, command: &str) {
        let css = format!("[data-command=\"{command}\"]");
        self.client
            .find(Locator::Css(&css))
            .await
            .unwrap()
            .click()
            .await
            .unwrap();
    }

    /// Waits until a script gives true.
    ///
    /// # Panics
    /// It does not within that time.
    pub async fn until(&self, name: &str, within: Duration, script: &str) {
        let end = Instant::now() + within;
        while self.run(script).await != Value::Bool(true) {
            assert!(Instant::now() < end, "{name} not within {within:?}");
            tokio::time::sleep(Duration::from_millis(50)).await;
        }
    }

    /// Sends a command of the browser's own protocol.
    ///
    /// # Panics
    /// The driver does not answer.
    pub fn protocol(&self, command: &str, parameters: &Value) -> Value {
        self.post(
            "goog/cdp/execute",
            &json!({"cmd": command, "params": parameters}),
        )
    }

    /// Sends a signal to each process that draws a page.
    ///
    /// # Panics
    /// There is none.
    #[allow(clippy::unwrap_used)]
    pub fn signal_renderers(&self, signal: Signal) {
        let group = Pid::from_raw(i32::try_from(self.driver.child.id()).unwrap());
        let mut found = 0;
        for process in std::fs::read_dir("/proc").unwrap().flatten() {
            let command = std::fs::read(process.path().join("cmdline")).unwrap_or_default();
            let id = process
                .file_name()
                .to_string_lossy()
                .parse()
                .map(Pid::from_raw);
            let Ok(id) = id else { continue };
            let draws = String::from_utf8_lossy(&command).contains("--type=renderer");
            if draws && nix::unistd::getpgid(Some(id)) == Ok(group) {
                found += 1;
                kill(id, signal).unwrap();
            }
        }
        assert!(found > 0, "no process draws a page");
    }

    /// Errors on the console so far.
    ///
    /// # Panics
    /// The driver does not answer.
    pub fn errors(&self) -> Vec<String> {
        let log = self.post("se/log", &json!({"type": "browser"}));
        let entries = log["value"].as_array().cloned().unwrap_or_default();
        entries
            .iter()
            .filter(|entry| entry["level"] == "SEVERE")
            .map(|entry| entry["message"].to_string())
            .collect()
    }

    #[allow(clippy::unwrap_used)]
    fn post(&self, path: &str, body: &Value) -> Value {
        let mut stream = TcpStream::connect(self.driver.address).unwrap();
        stream
            .set_read_timeout(Some(Duration::from_secs(30)))
            .unwrap();
        let body = body.to_string();
        let request = format!(
            "POST /session/{}/{path} HTTP/1.1\r\nHost: {}\r\nContent-Type: application/json\r\n\
             Content-Length: {}\r\nConnection: close\r\n\r\n{body}",
            self.session,
            self.driver.address,
            body.len()
        );
        stream.write_all(request.as_bytes()).unwrap();
        // The driver keeps the connection open: the length says where the answer ends.
        let mut answer = BufReader::new(stream);
        let (mut line, mut length) = (String::new(), 0_u64);
        while answer.read_line(&mut line).unwrap_or(0) > 2 {
            let lower = line.to_ascii_lowercase();
            if let Some(value) = lower.strip_prefix("content-length:") {
                length = value.trim().parse().unwrap_or(0);
            }
            line.clear();
        }
        let mut body = Vec::new();
        let _ = answer.take(length).read_to_end(&mut body);
        serde_json::from_slice(&body).unwrap_or(Value::Null)
    }

    /// Ends the browser in good order.
    pub async fn close(self) {
        let _ = self.client.clone().close().await;
    }
}
