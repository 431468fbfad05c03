package dev.eventchain.diagnostics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Work whose result nobody wants any more. */
class CancellationTest {

  private final AtomicBoolean isUnwanted = new AtomicBoolean();

  @Test
  void workEndsWhereItReadsTheNextFile(@TempDir Path folder) throws Exception {
    Path file = Files.writeString(folder.resolve("a"), "text");
    assertThrows(
        Cancellation.CancelledException.class,
        () ->
            Cancellation.during(
                isUnwanted::get,
                () -> {
                  assertEquals("text", SourceText.read(file).text());
                  isUnwanted.set(true);
                  return SourceText.read(file);
                }));
    assertEquals("text", SourceText.read(file).text());
  }

  @Test
  void threadsKnowTheWorkThatTheyBelongTo() throws Exception {
    isUnwanted.set(true);
    CompletableFuture<Boolean> ofThread = new CompletableFuture<>();
    Cancellation outside = Cancellation.current();
    Cancellation inside =
        Cancellation.during(
            isUnwanted::get,
            () -> {
              new Thread(() -> ofThread.complete(Cancellation.current().isRequested())).start();
              return Cancellation.current();
            });
    assertTrue(ofThread.get());
    assertTrue(inside.isRequested());
    assertFalse(outside.isRequested());
  }
}
