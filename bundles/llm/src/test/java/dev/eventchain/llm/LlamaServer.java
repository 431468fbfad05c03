package dev.eventchain.llm;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Assumptions;

/**
 * llama.cpp's own HTTP server with a language model of random weights: it proves the wire, and says
 * nothing about prompts.
 */
final class LlamaServer implements AutoCloseable {

  private static final Path SOURCES = Path.of("src/test/python").toAbsolutePath();
  private static final Path FOLDER = Path.of("target/llama").toAbsolutePath();
  private static final long MINUTES = 10;

  private final Process process;
  private final String url;

  private LlamaServer(Process process, String url) {
    this.process = process;
    this.url = url;
  }

  /** Starts it; the test is skipped, with the reason, where its packages cannot be installed. */
  static LlamaServer start(String key) throws IOException, InterruptedException {
    Path python = FOLDER.resolve("venv/bin/python");
    Path done = FOLDER.resolve("installed");
    if (!Files.exists(done)) {
      Files.createDirectories(FOLDER);
      need("python3", "-m", "venv", FOLDER.resolve("venv").toString());
      String requirements = SOURCES.resolve("requirements.txt").toString();
      need(python.toString(), "-m", "pip", "install", "-q", "-r", requirements);
      Files.createFile(done);
    }
    Path model = FOLDER.resolve("tiny.gguf");
    need(python.toString(), SOURCES.resolve("tiny_model.py").toString(), model.toString());
    Process process =
        new ProcessBuilder(
                python.toString(), SOURCES.resolve("serve.py").toString(), model.toString(), key)
            .redirectError(FOLDER.resolve("server.log").toFile())
            .start();
    BufferedReader lines =
        new BufferedReader(
            new java.io.InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
    for (String line = lines.readLine(); line != null; line = lines.readLine()) {
      if (line.startsWith("READY ")) {
        return new LlamaServer(process, line.substring("READY ".length()).strip());
      }
    }
    throw new AssertionError(Files.readString(FOLDER.resolve("server.log")));
  }

  private static void need(String... command) throws IOException, InterruptedException {
    Path log = FOLDER.resolve("install.log");
    Process process =
        new ProcessBuilder(List.of(command))
            .redirectErrorStream(true)
            .redirectOutput(log.toFile())
            .start();
    boolean ended = process.waitFor(MINUTES, TimeUnit.MINUTES);
    if (!ended || process.exitValue() != 0) {
      process.destroyForcibly();
      String reason = "llama.cpp's server cannot be had here: " + Files.readString(log);
      System.out.println(reason);
      Assumptions.abort(reason);
    }
  }

  /** Where it is, with the path that all requests share. */
  String url() {
    return url + "/v1";
  }

  @Override
  public void close() {
    process.destroyForcibly();
  }
}
