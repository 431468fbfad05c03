package dev.eventchain.lsp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Cancellation;
import dev.eventchain.lsp.language.Languages;
import dev.eventchain.lsp.text.OpenTexts;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

/** Answers that an editor does not want any more ({@code $/cancelRequest}). */
class CancelledAnswersTest {

  /** Answers come one after the other: one that goes on would keep all others from coming. */
  @Test
  void anAnswerEndsWhenItIsCancelled() throws Exception {
    try (Languages languages = new Languages(List.of(), new OpenTexts())) {
      CountDownLatch isAnswering = new CountDownLatch(1);
      CountDownLatch hasEnded = new CountDownLatch(1);
      CompletableFuture<String> endless =
          languages.later(
              () -> {
                isAnswering.countDown();
                try {
                  while (true) {
                    Cancellation.check();
                  }
                } finally {
                  hasEnded.countDown();
                }
              });
      CompletableFuture<String> next = languages.later(() -> "next");
      isAnswering.await();
      endless.cancel(true);
      assertTrue(hasEnded.await(60, TimeUnit.SECONDS));
      assertEquals("next", next.get(60, TimeUnit.SECONDS));
      assertTrue(endless.isCancelled());
    }
  }
}
