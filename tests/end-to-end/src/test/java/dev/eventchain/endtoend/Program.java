package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.fixtures.Projects;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The program, from the jars that the launcher starts. It runs in the process of the tests unless a
 * test sets its environment, starts it by another program or needs a process: starting Java takes
 * longer than most commands.
 */
final class Program {

  /** The project's root folder, where the tests run. */
  static final Path ROOT = Path.of("").toAbsolutePath();

  private static final Set<String> SCENARIOS = Set.of("empty-road.yaml", "stopped-vehicle-50.yaml");

  /** Time limit in seconds for the slowest machines; nothing should wait forever. */
  static final long LONGEST_SECONDS = 1800;

  private static final int TRIES = 20;

  private final Map<String, String> environment = new TreeMap<>();
  private final List<String> prefix = new ArrayList<>();

  /**
   * The end of the program.
   *
   * @param code its exit code
   */
  record Ended(int code, String out, String err) {

    /** Fails with the whole output unless the exit code is the expected one. */
    Ended expect(int expected) {
      assertTrue(
          code == expected,
          () ->
              "exit code "
                  + code
                  + ", not "
                  + expected
                  + "\n--- out\n"
                  + out
                  + "\n--- err\n"
                  + err);
      return this;
    }

    /** Fails with the whole output unless it contains a text. */
    Ended says(String text) {
      assertTrue(
          out.contains(text) || err.contains(text),
          () -> "nowhere: " + text + "\n--- out\n" + out + "\n--- err\n" + err);
      return this;
    }

    /** Fails with the whole output if it contains a text. */
    Ended saysNothingOf(String text) {
      assertFalse(
          out.contains(text) || err.contains(text),
          () -> "unexpected: " + text + "\n--- out\n" + out + "\n--- err\n" + err);
      return this;
    }
  }

  /** Sets an environment variable for the program, unless the tests themselves have it. */
  Program with(String name, String value) {
    if (!value.equals(System.getenv(name))) {
      environment.put(name, value);
    }
    return this;
  }

  /** Starts the program by another one. */
  Program by(String... command) {
    prefix.addAll(List.of(command));
    return this;
  }

  /** Runs the program to its end. */
  Ended run(Object... arguments) {
    if (environment.isEmpty() && prefix.isEmpty()) {
      return ProgramInside.run(Stream.of(arguments).map(String::valueOf).toList());
    }
    return runAsProcess(arguments);
  }

  private Ended runAsProcess(Object... arguments) {
    try {
      Path out = Files.createTempFile("eventchain", ".out");
      Path err = Files.createTempFile("eventchain", ".err");
      Process process = start(out, err, arguments);
      if (!process.waitFor(LONGEST_SECONDS, TimeUnit.SECONDS)) {
        process.destroyForcibly().waitFor();
        throw new AssertionError("still running: " + Files.readString(err));
      }
      Ended ended = new Ended(process.exitValue(), Files.readString(out), Files.readString(err));
      Files.delete(out);
      Files.delete(err);
      return ended;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException(e);
    }
  }

  /**
   * Starts the program, and halts it like Ctrl-Z once it has printed a text to standard error. The
   * next action then happens in the middle of its work, however fast or busy the machine is.
   */
  Process haltedAt(String text, Path out, Path err, Object... arguments)
      throws IOException, InterruptedException {
    for (int i = 0; i < TRIES; i++) {
      Process process = start(out, err, arguments);
      while (process.isAlive() && !Files.readString(err).contains(text)) {
        Thread.sleep(1);
      }
      signal(process, "STOP");
      while (process.isAlive() && !isHalted(process)) {
        Thread.sleep(1);
      }
      if (process.isAlive()) {
        return process;
      }
      // It ended before it was halted, which only happens if this test waited for long.
    }
    throw new AssertionError("it always ends before it can be halted: " + Files.readString(err));
  }

  private static boolean isHalted(Process process) throws IOException {
    Path status = Path.of("/proc", Long.toString(process.pid()), "status");
    return !Files.exists(status) || Files.readString(status).contains("State:\tT");
  }

  /** Sends a signal to a process. */
  static void signal(Process process, String name) throws IOException, InterruptedException {
    new ProcessBuilder("kill", "-" + name, Long.toString(process.pid())).start().waitFor();
  }

  /**
   * Interrupts a process like Ctrl-C where it reaches only that process; returns its exit code.
   * Fails if a process that it has started is still there a minute later.
   */
  static int interrupt(Process process) throws IOException, InterruptedException {
    List<ProcessHandle> started = process.descendants().toList();
    signal(process, "INT");
    int code = process.waitFor();
    for (ProcessHandle each : started) {
      try {
        each.onExit().get(60, TimeUnit.SECONDS);
      } catch (ExecutionException | TimeoutException e) {
        started.forEach(ProcessHandle::destroyForcibly);
        throw new AssertionError("still running: " + each.info(), e);
      }
    }
    return code;
  }

  /** Returns a shell script that starts the program with the script's arguments, in its folder. */
  String script() {
    String words = command().stream().map(w -> "'" + w + "'").collect(Collectors.joining(" "));
    return "#!/usr/bin/env bash\nexec " + words + " \"$@\"\n";
  }

  private List<String> command() {
    List<String> command = new ArrayList<>(prefix);
    command.add(LaunchedJava.JAVA.toString());
    command.addAll(LaunchedJava.OPTIONS);
    command.addAll(List.of("-cp", ProgramInside.CLASS_PATH, ProgramInside.MAIN));
    return command;
  }

  /** Starts the program with its output in files. */
  Process start(Path out, Path err, Object... arguments) throws IOException {
    List<String> command = command();
    Stream.of(arguments).map(String::valueOf).forEach(command::add);
    ProcessBuilder builder = new ProcessBuilder(command).directory(ROOT.toFile());
    builder.environment().putAll(environment);
    return builder.redirectOutput(out.toFile()).redirectError(err.toFile()).start();
  }

  /** Starts the program with pipes to its input and output. */
  Process startWithPipes(String... arguments) throws IOException {
    List<String> command = command();
    command.addAll(List.of(arguments));
    ProcessBuilder builder = new ProcessBuilder(command).directory(ROOT.toFile());
    builder.environment().putAll(environment);
    return builder.redirectError(ProcessBuilder.Redirect.DISCARD).start();
  }

  /**
   * Returns the nodes on the longest path of each latency constraint in each scenario of a run;
   * fails if their waiting and execution times do not add up to the latency.
   */
  static List<String> slowestPaths(Path project) throws IOException {
    JsonNode measured =
        new ObjectMapper().readTree(project.resolve("out/measurements.json").toFile());
    List<String> paths = new ArrayList<>();
    for (JsonNode scenario : measured.path("scenarios")) {
      for (JsonNode latency : scenario.path("latencies")) {
        List<String> nodes = new ArrayList<>();
        double sum = 0;
        for (JsonNode part : latency.path("slowest")) {
          nodes.add(part.path("node").asText());
          sum += part.path("waiting").asDouble() + part.path("execution").asDouble();
        }
        // Each number is rounded to four decimals.
        assertEquals(latency.path("maximum").asDouble(), sum, 1e-4 * (1 + nodes.size()));
        paths.add(String.join(" ", nodes));
      }
    }
    return paths;
  }

  /**
   * Fails if a latency was measured above what the model makes possible, or if none was measured.
   * In simulated time, components without a worst-case execution time take none; where all timers
   * are aligned besides, a latency is 0.
   */
  static void requireBoundsHold(Path project) throws IOException {
    JsonNode all = new ObjectMapper().readTree(project.resolve("out/latency-bounds.json").toFile());
    int measured = 0;
    for (JsonNode latency : all) {
      if (latency.has("measured")) {
        double longest = latency.path("measured").path("longest").asDouble(-1);
        assertTrue(longest >= 0 && longest <= latency.path("known").asDouble(), latency::toString);
        measured++;
      }
    }
    assertTrue(measured > 0, all::toString);
  }

  /**
   * Returns a copy of the AEB example without results of runs, and with two scenarios only: they
   * prove all of its requirements, and tests about other features need not wait for the rest.
   */
  static Path exampleIn(Path folder) throws IOException {
    Path copy = wholeExampleIn(folder);
    try (Stream<Path> scenarios = Files.list(copy.resolve("scenarios"))) {
      for (Path file : scenarios.toList()) {
        if (!SCENARIOS.contains(file.getFileName().toString())) {
          Files.delete(file);
        }
      }
    }
    Path faults = copy.resolve("faults.yaml");
    Files.writeString(faults, Files.readString(faults).replace(", slower-vehicle]", "]"));
    return copy;
  }

  /** Returns a copy of the AEB example with all of its scenarios, without results of runs. */
  static Path wholeExampleIn(Path folder) throws IOException {
    return copyOf("aeb", folder);
  }

  /**
   * Returns a copy of an example without results of runs, and without strength; also without tests
   * of its existing components, which find most defects before a scenario does.
   */
  static Path copyOf(String example, Path folder) throws IOException {
    Path copy = folder.resolve(example);
    Projects.copy(ROOT.resolve("examples").resolve(example), copy);
    Files.deleteIfExists(copy.resolve("mutants.yaml"));
    Path tests = copy.resolve("tests");
    if (Files.isDirectory(tests)) {
      try (Stream<Path> files = Files.list(tests)) {
        for (Path file : files.toList()) {
          Files.delete(file);
        }
      }
      Files.delete(tests);
    }
    return Projects.withoutStrength(copy);
  }
}
