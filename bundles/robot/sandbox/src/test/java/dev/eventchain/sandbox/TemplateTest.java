package dev.eventchain.sandbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Forks of a template are as separate from each other as new interpreters. */
class TemplateTest {

  private static final ConfinedProcess.Limits LIMITS =
      new ConfinedProcess.Limits(Duration.ofMinutes(2), Duration.ofSeconds(1), 256);

  /** Surroundings as far as a program can see them. */
  private static final String SURROUNDINGS =
      """
      import gc, os, resource, signal, sys, threading
      def look(what, *arguments):
          try:
              return what(*arguments)
          except OSError as problem:
              return type(problem).__name__
      print("environment", sorted(os.environ.items()))
      print("python", sys.path, sys.argv, sys.flags, sys.prefix, hash("text"), gc.get_threshold())
      print("settings", sys.getrecursionlimit(), sys.dont_write_bytecode, os.umask(0))
      print("session", os.getsid(0) == os.getpid() or os.getpid() < 5, os.getcwd(), os.getuid())
      kinds = [name for name in sorted(dir(resource)) if name.startswith("RLIMIT")]
      print("limits", [(name, resource.getrlimit(getattr(resource, name))) for name in kinds])
      print("signals", [str(signal.getsignal(number)) for number in range(1, 32)])
      print("root", look(os.listdir, "/"), look(os.listdir, "/proc"))
      print("streams", [not isinstance(look(os.fstat, number), str) for number in range(100)])
      print("buffers", [(each.encoding, each.line_buffering) for each in (sys.stdin, sys.stdout, sys.stderr)])
      print("threads", threading.active_count(), threading.current_thread().name)
      """;

  private static final String POISON =
      """
      import atexit, builtins, json, os, pathlib, random, socket, sys, tempfile
      builtins.len = lambda value: 42
      json.dumps = lambda value: "poisoned"
      os.environ["POISON"] = "1"
      sys.modules["helper"] = sys
      sys.path.append("/poison")
      sys.setrecursionlimit(77)
      pathlib.Path("poison.txt").write_text("1")
      pathlib.Path("component_client.py").write_text("raise SystemExit(9)")
      """;

  private static final String CLEAN =
      """
      import json, os, pathlib, sys
      print(len("ab"), json.dumps([1]), "POISON" in os.environ, "helper" in sys.modules)
      print("/poison" in sys.path, sys.getrecursionlimit() > 500, os.listdir("."))
      """;

  private static final Run UNCHANGED = new Run("2 [1] False False\nFalse True []\n", "EXITED 0");

  @TempDir static Path folder;

  static List<Confinement> confinements() {
    return TestEnvironment.confinements();
  }

  /** The first process of a kind is a new interpreter. */
  @BeforeAll
  static void startATemplate() throws IOException {
    run(builder("pass", Confinement.AUDIT_HOOKS));
  }

  @ParameterizedTest
  @MethodSource("confinements")
  void aForkSeesWhatANewInterpreterSees(Confinement confinement) throws IOException {
    Run expected = run(builder(SURROUNDINGS, confinement).withoutTemplate());
    assertEquals(expected, fork(SURROUNDINGS, confinement));
    assertTrue(expected.output().contains("threads 1 MainThread"), expected::toString);
  }

  /** Programs, and how they end. */
  static Stream<Arguments> ends() {
    Map<String, String> programs =
        Map.of(
            POISON,
            "EXITED 0",
            "import os; os.abort()",
            "EXITED 134",
            "import os; os._exit(3)",
            "EXITED 3",
            "while True: pass",
            "CPU_TIME 152",
            "held = []\nwhile True: held.append(bytearray(1 << 20))",
            "EXITED 1");
    return confinements().stream()
        .flatMap(
            confinement ->
                programs.entrySet().stream()
                    .map(each -> Arguments.of(confinement, each.getKey(), each.getValue())));
  }

  @ParameterizedTest
  @MethodSource("ends")
  void whatOneForkDoesChangesNothingForTheNext(Confinement confinement, String program, String end)
      throws IOException {
    assertEquals(end, fork(program, confinement).end());
    assertEquals(UNCHANGED, fork(CLEAN, confinement));
  }

  @ParameterizedTest
  @MethodSource("confinements")
  void aForkThatHangsHoldsUpNoOther(Confinement confinement) throws IOException {
    ConfinedProcess hangs =
        builder("print(flush=True); input()", confinement)
            .workFolder(Files.createDirectory(folder.resolve("hangs in " + confinement)))
            .start();
    assertEquals('\n', hangs.stdout().read());
    assertTrue(hangs.isForked());
    assertEquals(UNCHANGED, fork(CLEAN, confinement));
    assertTrue(hangs.isAlive());
    hangs.close();
    assertFalse(hangs.isAlive());
    assertEquals(ConfinedProcess.Cause.CLOSED, hangs.await().cause());
  }

  @Test
  void manyThreadsStartForksAtTheSameTime() throws Exception {
    Path script = Files.writeString(folder.resolve("many.py"), "print('here')");
    List<Callable<String>> starts = new ArrayList<>();
    for (int i = 0; i < 24; i++) {
      Path work = Files.createDirectory(folder.resolve("work of " + i));
      starts.add(
          () -> {
            try (ConfinedProcess process =
                ConfinedProcess.on(TestEnvironment.PYTHON)
                    .script(script)
                    .workFolder(work)
                    .limits(LIMITS)
                    .start()) {
              return process.isForked() + " " + run(process);
            }
          });
    }
    ExecutorService threads = Executors.newFixedThreadPool(8);
    try {
      for (Future<String> each : threads.invokeAll(starts)) {
        assertEquals("true " + new Run("here\n", "EXITED 0"), each.get());
      }
    } finally {
      threads.shutdown();
    }
  }

  @ParameterizedTest
  @MethodSource("confinements")
  void whenTheTemplateEndsItsForksDoAndNewInterpretersAreStarted(Confinement confinement)
      throws IOException {
    int seed = confinement == Confinement.BUBBLEWRAP ? 1001 : 1002; // a template of its own
    run(builder("pass", confinement).hashSeed(seed));
    try (ConfinedProcess forked =
        builder("print(flush=True); input()", confinement).hashSeed(seed).start()) {
      assertEquals('\n', forked.stdout().read());
      List<ProcessHandle> all = forked.processes().toList();
      all.get(0).parent().orElseThrow().destroyForcibly();
      assertEquals(128 + 9, forked.await().exitCode());
      all.forEach(each -> each.onExit().join());
      try (ConfinedProcess next = builder("print('here')", confinement).hashSeed(seed).start()) {
        assertFalse(next.isForked());
        assertTrue(next.await().isSuccess());
      }
    }
  }

  /** Output of a program, and how it ended. */
  private record Run(String output, String end) {}

  private static Run fork(String program, Confinement confinement) throws IOException {
    try (ConfinedProcess process = builder(program, confinement).start()) {
      assertTrue(process.isForked());
      return run(process);
    }
  }

  private static Run run(ConfinedProcess.Builder builder) throws IOException {
    try (ConfinedProcess process = builder.start()) {
      return run(process);
    }
  }

  private static Run run(ConfinedProcess process) throws IOException {
    process.stdin().close();
    String output = new String(process.stdout().readAllBytes(), StandardCharsets.UTF_8);
    ConfinedProcess.Termination end = process.await();
    return new Run(output, end.cause() + " " + end.exitCode());
  }

  private static ConfinedProcess.Builder builder(String program, Confinement confinement)
      throws IOException {
    Path work = folder.resolve("work");
    if (Files.exists(work)) {
      AbandonedFolders.delete(work);
    }
    return ConfinedProcess.on(TestEnvironment.PYTHON)
        .script(Files.writeString(folder.resolve("program.py"), program))
        .workFolder(Files.createDirectory(work))
        .limits(LIMITS)
        .confinement(confinement);
  }
}
