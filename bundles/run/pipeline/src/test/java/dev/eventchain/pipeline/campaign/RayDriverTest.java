package dev.eventchain.pipeline.campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests what is said about a driver of Ray, for which a shell script stands. */
class RayDriverTest {

  private static final SourceLocation PLACE = SourceLocation.of("approach.yaml");

  @TempDir Path folder;

  private RayDriver driver(String script) throws IOException {
    return driver(script, Duration.ofMinutes(20));
  }

  private RayDriver driver(String script, Duration longestSilence) throws IOException {
    Path file = Files.writeString(folder.resolve("python"), "#!/bin/sh\n" + script + "\n");
    assertTrue(file.toFile().setExecutable(true));
    return new RayDriver(file, PLACE, longestSilence);
  }

  private static Diagnostic failure(RayDriver driver) {
    DiagnosticException e = assertThrows(DiagnosticException.class, driver::receive);
    assertEquals(DiagnosticException.Reason.UNAVAILABLE, e.reason());
    Diagnostic found = e.diagnostics().get(0);
    assertEquals("campaign.engine", found.id());
    assertEquals(PLACE, found.location());
    return found;
  }

  @Test
  void messagesAreLines() throws IOException {
    try (RayDriver driver = driver("read line; echo \"$line\"")) {
      driver.send(Map.of("count", 3));
      assertEquals(3, driver.receive().path("count").asInt());
    }
  }

  @Test
  void whatItSaysLastIsReported() throws IOException {
    try (RayDriver driver = driver("echo '{\"error\": \"No cluster\", \"hint\": \"Start it.\"}'")) {
      Diagnostic found = failure(driver);
      assertEquals("No cluster.", found.message());
      assertEquals("Start it.", found.hint());
    }
    String script =
        "echo 'Traceback' >&2; echo 'KeyError: 1' >&2; echo '[E] :info_message: x' >&2; exit 1";
    try (RayDriver driver = driver(script)) {
      driver.send("a driver that has ended is asked");
      assertEquals("The driver of Ray ended early: KeyError: 1.", failure(driver).message());
    }
    try (RayDriver driver = driver("echo nonsense")) {
      assertTrue(failure(driver).message().startsWith("The driver of Ray cannot be understood"));
    }
  }

  @Test
  void thatItIsAliveIsNoMessage() throws IOException {
    String alive = "echo '{\"alive\": true}'; ";
    try (RayDriver driver = driver(alive + alive + "echo '{\"part\": 4}'")) {
      assertEquals(4, driver.receive().path("part").asInt());
      assertTrue(failure(driver).message().startsWith("The driver of Ray ended early"));
    }
  }

  /** As one that Ray does not answer. */
  @Test
  void silenceIsNotForEver() throws IOException {
    try (RayDriver driver = driver("read line; exec sleep 10000", Duration.ofSeconds(1))) {
      Diagnostic found = failure(driver);
      assertEquals("The driver of Ray has said nothing for 1 s.", found.message());
      assertTrue(found.hint().contains("the same command goes on"), found.hint());
    }
  }

  /** The script would wait for ever; its input ends. */
  @Test
  void itEndsWithItsInput() throws IOException {
    Path ended = folder.resolve("ended");
    driver("while read line; do :; done; touch " + ended).close();
    assertTrue(Files.exists(ended));
  }
}
