package dev.eventchain.m2t;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.Thorough;
import dev.eventchain.m2t.generation.GenerationContext;
import dev.eventchain.m2t.generation.GenerationResult;
import dev.eventchain.m2t.generation.GenerationTrace;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Repeated and concurrent generations give equal results. */
class SameBytesTest {
  private static final Path CASES = Path.of("src/test/resources/cases");
  private static final int THREADS = Thorough.IS_ON ? 8 : 4;
  private static final int RUNS_EACH = 3;

  /** Comparable result of a run. */
  private record Given(
      SortedMap<String, String> files,
      String findings,
      SortedMap<String, List<GenerationTrace.Segment>> trace) {
    static Given of(GenerationResult result) {
      SortedMap<String, String> files = new TreeMap<>();
      result
          .files()
          .forEach(
              (name, bytes) -> files.put(name, new String(bytes, StandardCharsets.ISO_8859_1)));
      return new Given(files, TemplateCase.text(result.diagnostics()), result.trace().files());
    }
  }

  static Stream<Path> shippedTemplates() throws Exception {
    try (Stream<Path> all = Files.walk(CASES)) {
      return all
          .filter(folder -> Files.exists(folder.resolve("links.properties")))
          .sorted()
          .toList()
          .stream();
    }
  }

  static List<Path> someTemplates() throws Exception {
    return Thorough.allOrOneIn(4, shippedTemplates().toList());
  }

  @ParameterizedTest
  @MethodSource("someTemplates")
  void manyThreadsWithOneModuleGiveWhatTheFirstRunGave(Path folder) throws Exception {
    TemplateCase.Prepared prepared = new TemplateCase(folder).prepare();
    Given first = Given.of(prepared.generate(UnaryOperator.identity()));
    Given traced = Given.of(prepared.generate(GenerationContext::withTrace));
    assertFalse(first.files().isEmpty());
    assertEquals(first.files(), traced.files());
    assertFalse(traced.trace().isEmpty());
    for (Future<List<Given>> several : onThreads(prepared)) {
      for (Given each : several.get()) {
        Given expected = each.trace().isEmpty() ? first : traced;
        assertEquals(expected, each);
      }
    }
  }

  /** Generates on threads that start simultaneously, some with a trace, some without. */
  private static List<Future<List<Given>>> onThreads(TemplateCase.Prepared prepared)
      throws Exception {
    ExecutorService threads = Executors.newFixedThreadPool(THREADS);
    CountDownLatch ready = new CountDownLatch(THREADS);
    try {
      List<Future<List<Given>>> found = new ArrayList<>();
      for (int i = 0; i < THREADS; i++) {
        UnaryOperator<GenerationContext> changed =
            i % 2 == 0 ? UnaryOperator.identity() : GenerationContext::withTrace;
        found.add(threads.submit(() -> several(prepared, changed, ready)));
      }
      threads.shutdown();
      assertTrue(threads.awaitTermination(1, TimeUnit.HOURS));
      return found;
    } finally {
      threads.shutdownNow();
    }
  }

  private static List<Given> several(
      TemplateCase.Prepared prepared,
      UnaryOperator<GenerationContext> changed,
      CountDownLatch ready)
      throws InterruptedException {
    ready.countDown();
    ready.await();
    List<Given> found = new ArrayList<>();
    for (int i = 0; i < RUNS_EACH; i++) {
      found.add(Given.of(prepared.generate(changed)));
    }
    return found;
  }

  @ParameterizedTest
  @MethodSource("someTemplates")
  void threadsThatAreTheFirstToEvaluateAnythingAgree(Path folder) throws Exception {
    TemplateCase.Prepared prepared = new TemplateCase(folder).prepare();
    List<Given> all = new ArrayList<>();
    for (Future<List<Given>> several : onThreads(prepared)) {
      all.addAll(several.get());
    }
    Given expected =
        Given.of(new TemplateCase(folder).prepare().generate(GenerationContext::withTrace));
    for (Given each : all) {
      assertEquals(expected.files(), each.files());
      assertEquals(expected.findings(), each.findings());
    }
  }

  @Test
  void aModelThatIsLoadedAgainGivesTheSame() throws Exception {
    for (Path folder : someTemplates()) {
      Given one =
          Given.of(new TemplateCase(folder).prepare().generate(GenerationContext::withTrace));
      Given two =
          Given.of(new TemplateCase(folder).prepare().generate(GenerationContext::withTrace));
      assertEquals(one, two);
    }
  }
}
