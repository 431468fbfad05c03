package dev.eventchain.sandbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class ConfinedProcessTest {

  @TempDir Path folder;

  @ParameterizedTest
  @MethodSource("dev.eventchain.sandbox.TestEnvironment#confinements")
  void programReadsItsPathsWritesItsFolderAndUsesNumPy(Confinement confinement) throws IOException {
    Path data = Files.writeString(folder.resolve("data.txt"), "7");
    String output =
        run(
            confinement,
            """
            import os, pathlib, sys, tempfile, threading
            import numpy
            from helper import twice
            value = twice(int(numpy.sum(numpy.array([int(open(sys.argv[1]).read())]))))
            pathlib.Path("result.txt").write_text(str(value))
            pathlib.Path("folder").mkdir()
            with tempfile.TemporaryFile() as file:
                file.write(b"x")
            thread = threading.Thread(target=lambda: print(value))
            thread.start()
            thread.join()
            print(os.getcwd() == str(pathlib.Path.home()), sys.stdin.read())
            """,
            data);
    assertEquals("14\nTrue hello\n", output);
    assertEquals("14", Files.readString(folder.resolve("work/result.txt")));
    assertTrue(Files.isDirectory(folder.resolve("work/folder")));
  }

  private String run(Confinement confinement, String program, Path data) throws IOException {
    Path script = Files.writeString(folder.resolve("program.py"), program);
    Path library = Files.createDirectory(folder.resolve("library"));
    Files.writeString(library.resolve("helper.py"), "def twice(x):\n    return 2 * x\n");
    try (ConfinedProcess process =
        ConfinedProcess.on(TestEnvironment.PYTHON)
            .script(script)
            .arguments(data.toString())
            .readable(data)
            .pythonPath(library)
            .workFolder(Files.createDirectory(folder.resolve("work")))
            .confinement(confinement)
            .start()) {
      process.stdin().write("hello".getBytes(StandardCharsets.UTF_8));
      process.stdin().close();
      String output = new String(process.stdout().readAllBytes(), StandardCharsets.UTF_8);
      assertEquals(
          new ConfinedProcess.Termination(ConfinedProcess.Cause.EXITED, 0),
          process.await(),
          process.standardError());
      return output;
    }
  }

  @ParameterizedTest
  @MethodSource("dev.eventchain.sandbox.TestEnvironment#confinements")
  void processorTimeIsLimited(Confinement confinement) throws IOException {
    ConfinedProcess.Limits limits =
        new ConfinedProcess.Limits(Duration.ofSeconds(20), Duration.ofSeconds(1), 256);
    try (ConfinedProcess process = start(confinement, "while True: pass", limits)) {
      assertEquals(ConfinedProcess.Cause.CPU_TIME, process.await().cause());
    }
  }

  @ParameterizedTest
  @MethodSource("dev.eventchain.sandbox.TestEnvironment#confinements")
  void exitCodeAndErrorOutputAreReported(Confinement confinement) throws IOException {
    String program = "import sys; print('broken', file=sys.stderr); sys.exit(42)";
    try (ConfinedProcess process = start(confinement, program, standard())) {
      assertEquals(42, process.await().exitCode());
      assertEquals("broken\n", process.standardError());
    }
  }

  @ParameterizedTest
  @MethodSource("dev.eventchain.sandbox.TestEnvironment#confinements")
  void closingEndsTheProcess(Confinement confinement) throws IOException {
    ConfinedProcess process = start(confinement, "import time; time.sleep(60)", standard());
    process.close();
    assertFalse(process.isAlive());
    assertEquals(ConfinedProcess.Cause.CLOSED, process.await().cause());
  }

  @ParameterizedTest
  @MethodSource("dev.eventchain.sandbox.TestEnvironment#confinements")
  void processSurvivesTheThreadThatStartedIt(Confinement confinement) throws Exception {
    var process = new java.util.concurrent.atomic.AtomicReference<ConfinedProcess>();
    Thread starter =
        new Thread(() -> process.set(startUnchecked(confinement, "input(); print('still here')")));
    starter.start();
    starter.join();
    try (ConfinedProcess running = process.get()) {
      running.stdin().write('\n');
      running.stdin().close();
      byte[] output = running.stdout().readAllBytes();
      assertEquals("still here\n", new String(output, StandardCharsets.UTF_8));
    }
  }

  private ConfinedProcess startUnchecked(Confinement confinement, String program) {
    try {
      return start(confinement, program, standard());
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }

  @ParameterizedTest
  @MethodSource("dev.eventchain.sandbox.TestEnvironment#confinements")
  void aPreparationMakesWhatTheProgramMayUseButNotMake(Confinement confinement) throws IOException {
    Path library = Files.createDirectory(folder.resolve("library"));
    Files.writeString(
        library.resolve("before.py"),
        """
        import socket, threading
        def prepare(settings):
            global ours
            ours = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
            ours.bind((settings["host"], 0))
        """);
    String program =
        """
        import socket
        import before
        ours, other = before.ours, before.ours.getsockname()
        before.ours.sendto(b"to myself", other)
        print(ours.recv(100).decode())
        try:
            socket.socket()
            print("a socket was made")
        except OSError as refused:
            print("refused")
        """;
    Path script = Files.writeString(folder.resolve("program.py"), program);
    try (ConfinedProcess process =
        ConfinedProcess.on(TestEnvironment.PYTHON)
            .script(script)
            .pythonPath(library)
            .preparation("before", JsonNodeFactory.instance.objectNode().put("host", "127.0.0.1"))
            .workFolder(Files.createDirectory(folder.resolve("work")))
            .confinement(confinement)
            .withoutHooks()
            .start()) {
      String output = new String(process.stdout().readAllBytes(), StandardCharsets.UTF_8);
      assertEquals("to myself\nrefused\n", output, process::standardError);
    }
  }

  @ParameterizedTest
  @MethodSource("dev.eventchain.sandbox.TestEnvironment#confinements")
  void aProcessThatSomebodyHasStoppedIsSeen(Confinement confinement) throws Exception {
    String program = "print('here', flush=True); input()";
    try (ConfinedProcess process = start(confinement, program, standard())) {
      assertEquals('h', process.stdout().read());
      assertFalse(process.isStopped());
      long deepest = process.processes().mapToLong(ProcessHandle::pid).max().orElseThrow();
      new ProcessBuilder("kill", "-STOP", Long.toString(deepest)).start().waitFor();
      while (!process.isStopped()) {
        Thread.sleep(5);
      }
    }
  }

  @Test
  void bubblewrapIsNotUsedWhenForbiddenOrAbsent() {
    assertEquals(Confinement.AUDIT_HOOKS, Confinement.detect(wanted("audit-hooks")));
    assertEquals(Confinement.AUDIT_HOOKS, Confinement.detect(Map.of("PATH", "/nowhere")));
  }

  @Test
  void unsetEmptyAndAutomaticAreTheSame() {
    Confinement found = Confinement.detect(Map.of("PATH", System.getenv("PATH")));
    assertEquals(found, Confinement.detect(wanted("")));
    assertEquals(found, Confinement.detect(wanted("auto")));
  }

  @ParameterizedTest
  @ValueSource(strings = {"nonsense", "Bubblewrap", "audit_hooks", "bubblewrap "})
  void unknownConfinementIsWrongUsage(String name) {
    var refusal = assertThrows(DiagnosticException.class, () -> Confinement.detect(wanted(name)));
    assertEquals(DiagnosticException.Reason.INPUT, refusal.reason());
    Diagnostic finding = refusal.diagnostics().get(0);
    assertEquals("python.confinement.unknown", finding.id());
    assertTrue(finding.message().contains("'" + name + "'"), finding.message());
    assertTrue(finding.hint().contains("bubblewrap or audit-hooks"), finding.hint());
  }

  @Test
  void demandedBubblewrapIsNotReplaced() {
    Map<String, String> settings =
        Map.of("PATH", "/nowhere", "EVENTCHAIN_CONFINEMENT", "bubblewrap");
    var refusal = assertThrows(DiagnosticException.class, () -> Confinement.detect(settings));
    assertEquals(DiagnosticException.Reason.UNAVAILABLE, refusal.reason());
    assertEquals("python.confinement.unavailable", refusal.diagnostics().get(0).id());
  }

  private static Map<String, String> wanted(String name) {
    return Map.of("PATH", System.getenv("PATH"), "EVENTCHAIN_CONFINEMENT", name);
  }

  private static ConfinedProcess.Limits standard() {
    return new ConfinedProcess.Limits(Duration.ofSeconds(20), Duration.ofSeconds(10), 256);
  }

  private ConfinedProcess start(
      Confinement confinement, String program, ConfinedProcess.Limits limits) throws IOException {
    Path script = Files.writeString(folder.resolve("program.py"), program);
    return ConfinedProcess.on(TestEnvironment.PYTHON)
        .script(script)
        .workFolder(Files.createDirectories(folder.resolve("work")))
        .limits(limits)
        .confinement(confinement)
        .start();
  }
}
