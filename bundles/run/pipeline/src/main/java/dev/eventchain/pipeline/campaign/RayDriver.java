package dev.eventchain.pipeline.campaign;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.pipeline.campaign.plan.CampaignRules;
import dev.eventchain.sandbox.PythonSources;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;

/**
 * The Python program that sends parts of a campaign to a Ray cluster, and the lines of JSON from
 * and to it, as {@code driver.py} describes them. It ends when its input does, so that nothing goes
 * on after the end of this JVM, however that comes.
 */
final class RayDriver implements AutoCloseable {

  private static final String RESOURCES = "dev/eventchain/pipeline/campaign/ray";
  private static final ObjectMapper JSON = new ObjectMapper();
  private static final int PATIENCE_SECONDS = 30;

  /** Longer than any step for which the driver waits without a word. */
  private static final Duration LONGEST_SILENCE = Duration.ofMinutes(20);

  private static final String KEPT =
      "Look at 'ray status'. What has come back is kept: the same command goes on.";

  /** Note of Ray about something that it went on after. */
  private static final String NOTE = ":info_message:";

  private final SourceLocation place;
  private final Path log;
  private final Process process;
  private final Writer input;
  private final Duration longestSilence;

  /** Lines from it, and an empty one once it has ended. */
  private final BlockingQueue<Optional<String>> output = new LinkedBlockingQueue<>();

  /**
   * Starts it.
   *
   * @param python a Python that has Ray
   * @param place what findings are about
   */
  RayDriver(Path python, SourceLocation place) {
    this(python, place, LONGEST_SILENCE);
  }

  /**
   * As above.
   *
   * @param longestSilence after which it is given up
   */
  RayDriver(Path python, SourceLocation place, Duration longestSilence) {
    this.place = place;
    this.longestSilence = longestSilence;
    Path folder = PythonSources.unpack(RayDriver.class.getClassLoader(), RESOURCES);
    ProcessBuilder builder =
        new ProcessBuilder(python.toString(), "-B", folder.resolve("driver.py").toString());
    // What a cluster of this machine starts uses this Java; other nodes have their own.
    builder.environment().put("JAVA_HOME", System.getProperty("java.home"));
    try {
      log = Files.createTempFile("eventchain-ray-", ".log");
      log.toFile().deleteOnExit(); // after Ctrl-C
      process = builder.redirectError(log.toFile()).start();
    } catch (IOException e) {
      throw failed("The driver of Ray cannot be started: " + SourceText.reason(e), "");
    }
    input = process.outputWriter(StandardCharsets.UTF_8);
    Thread reader = new Thread(() -> read(process.inputReader(StandardCharsets.UTF_8)), "ray");
    reader.setDaemon(true);
    reader.start();
  }

  private void read(BufferedReader lines) {
    try {
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        output.add(Optional.of(line));
      }
    } catch (IOException e) {
      // It has ended.
    } finally {
      output.add(Optional.empty());
    }
  }

  /** Sends a message. */
  void send(Object message) {
    try {
      input.write(JSON.writeValueAsString(message) + "\n");
      input.flush();
    } catch (JsonProcessingException e) {
      throw new IllegalStateException("a message is plain data", e);
    } catch (IOException e) {
      // It has ended; what it said last is read next.
    }
  }

  /**
   * Returns the next message that says more than that it is there.
   *
   * @throws DiagnosticException (UNAVAILABLE) {@code campaign.engine} if it says that something
   *     failed, has ended, or has said nothing for too long
   */
  JsonNode receive() {
    JsonNode message;
    try {
      do {
        message = JSON.readTree(line());
      } while (message.has("alive"));
    } catch (IOException e) {
      throw failed("The driver of Ray cannot be understood: " + SourceText.reason(e), "");
    }
    if (message.has("error")) {
      throw failed(message.path("error").asText(), message.path("hint").asText());
    }
    return message;
  }

  private String line() throws IOException {
    Optional<String> line;
    try {
      line = output.poll(longestSilence.toMillis(), TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("nobody interrupts a campaign", e);
    }
    if (line == null) {
      process.destroyForcibly();
      String silence = longestSilence.toSeconds() + " s";
      throw failed("The driver of Ray has said nothing for " + silence + ".", KEPT);
    }
    return line.orElseThrow(
        () -> failed("The driver of Ray ended early: " + lastWords(), "Did the node end? " + KEPT));
  }

  private String lastWords() {
    List<String> lines;
    try {
      lines =
          Files.readString(log, StandardCharsets.ISO_8859_1)
              .lines()
              .map(String::strip)
              .filter(line -> !line.contains(NOTE))
              .toList();
    } catch (IOException e) {
      lines = List.of();
    }
    return lines.isEmpty() ? "it says nothing." : lines.get(lines.size() - 1);
  }

  private DiagnosticException failed(String reason, String hint) {
    String message = reason.endsWith(".") ? reason : reason + ".";
    return new DiagnosticException(
        DiagnosticException.Reason.UNAVAILABLE,
        Diagnostic.of(CampaignRules.ENGINE, message, place).withHint(hint));
  }

  /** Ends it and all tasks. */
  @Override
  public void close() {
    try {
      input.close();
    } catch (IOException e) {
      // It has ended already.
    }
    try {
      if (!process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
        process.destroyForcibly();
      }
      Files.deleteIfExists(log);
    } catch (IOException e) {
      // A small file stays in the folder for temporary ones.
    } catch (InterruptedException e) {
      process.destroyForcibly();
      Thread.currentThread().interrupt();
    }
  }
}
