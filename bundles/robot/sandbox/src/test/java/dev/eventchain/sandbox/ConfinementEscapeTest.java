package dev.eventchain.sandbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.Thorough;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Each file of {@code escapes} makes one attempt to escape; it succeeds if it prints ESCAPED or
 * changes the folder that it is given.
 */
class ConfinementEscapeTest {

  private static final Path ESCAPES = Path.of("src/test/resources/escapes");
  private static final Path BOMBS = Path.of("src/test/resources/bombs");

  /** Limits for slow machines: an attempt ends by itself. */
  private static final ConfinedProcess.Limits LIMITS =
      new ConfinedProcess.Limits(Duration.ofMinutes(5), Duration.ofSeconds(10), 512);

  /**
   * Layers of confinement: both ways complete, and each without audit hooks or without the kernel's
   * layer.
   */
  private enum Layer {
    BUBBLEWRAP,
    BUBBLEWRAP_WITHOUT_HOOKS,
    AUDIT_HOOKS,
    KERNEL_WITHOUT_HOOKS,
    AUDIT_HOOKS_ALONE
  }

  @TempDir Path folder;

  /** The first process of a kind is a new interpreter, the others are forks of a template. */
  @BeforeAll
  static void startATemplate(@TempDir Path work) {
    try (ConfinedProcess first =
        ConfinedProcess.on(TestEnvironment.PYTHON)
            .script(BOMBS.resolve("sleeper.py"))
            .workFolder(work)
            .start()) {
      assertTrue(first.isAlive());
    }
  }

  static Stream<Arguments> escapes() throws IOException {
    return combine(ESCAPES, layers());
  }

  /** Each bomb in each layer; outside of the profile {@code thorough} in one layer a day. */
  static Stream<Arguments> bombs() throws IOException {
    return combine(BOMBS, Thorough.allOrOne(layers()));
  }

  private static List<Layer> layers() {
    return TestEnvironment.confinements().contains(Confinement.BUBBLEWRAP)
        ? List.of(Layer.values())
        : List.of(Layer.AUDIT_HOOKS, Layer.KERNEL_WITHOUT_HOOKS, Layer.AUDIT_HOOKS_ALONE);
  }

  private static Stream<Arguments> combine(Path programs, List<Layer> layers) throws IOException {
    List<Arguments> cases = new ArrayList<>();
    try (Stream<Path> files = Files.list(programs)) {
      for (Path program : files.sorted().toList()) {
        String source = Files.readString(program);
        for (Layer layer : layers) {
          if (!source.contains("# escapes from: " + layer.name().toLowerCase(Locale.ROOT))) {
            cases.add(Arguments.of(program.getFileName().toString(), layer));
          }
        }
      }
    }
    return cases.stream();
  }

  @ParameterizedTest(name = "{0} in {1}")
  @MethodSource("escapes")
  void attemptIsRefused(String program, Layer layer) throws IOException {
    check(builder(ESCAPES.resolve(program), layer), true);
  }

  /** Each attempt in each layer; outside of the profile {@code thorough} in one layer a day. */
  static Stream<Arguments> escapesFromInterpreters() throws IOException {
    return combine(ESCAPES, Thorough.allOrOne(layers()));
  }

  @ParameterizedTest(name = "{0} in {1}")
  @MethodSource("escapesFromInterpreters")
  void attemptInANewInterpreterIsRefused(String program, Layer layer) throws IOException {
    check(builder(ESCAPES.resolve(program), layer).withoutTemplate(), false);
  }

  private void check(ConfinedProcess.Builder builder, boolean isForked) throws IOException {
    Path outside = outside();
    Map<String, String> before = state(outside);
    String output;
    try (ConfinedProcess process = builder.arguments(outside.toString()).limits(LIMITS).start()) {
      assertEquals(isForked, process.isForked());
      output = new String(process.stdout().readAllBytes(), StandardCharsets.UTF_8);
      assertEquals(ConfinedProcess.Cause.EXITED, process.await().cause());
      assertFalse(output.contains("ESCAPED"), output);
      assertTrue(started(process), process.standardError());
    }
    assertEquals(before, state(outside));
  }

  /** Returns whether the attempt started: a failure of the harness would prove nothing. */
  private static boolean started(ConfinedProcess process) {
    String error = process.standardError();
    return error.isEmpty() || error.contains("resources/escapes/");
  }

  static Stream<Path> controls() throws IOException {
    List<Path> programs = new ArrayList<>();
    try (Stream<Path> files = Files.list(ESCAPES)) {
      for (Path program : files.sorted().toList()) {
        if (!Files.readString(program).contains("# control: none")) {
          programs.add(program);
        }
      }
    }
    return programs.stream();
  }

  /** An attempt that fails without confinement would prove nothing. */
  @ParameterizedTest
  @MethodSource("controls")
  void attemptSucceedsWithoutConfinement(Path program) throws Exception {
    Path outside = outside();
    Map<String, String> before = state(outside);
    Path copy = Files.copy(program, folder.resolve("program.py"));
    ProcessBuilder builder =
        new ProcessBuilder(
            TestEnvironment.PYTHON.executable().toString(), copy.toString(), outside.toString());
    builder.directory(Files.createDirectory(folder.resolve("work")).toFile());
    builder.environment().put("EVENTCHAIN_SECRET", "1");
    builder.redirectErrorStream(true);
    Process process = builder.start();
    String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    process.waitFor();
    assertTrue(output.contains("ESCAPED") || !before.equals(state(outside)), output);
  }

  @ParameterizedTest(name = "{0} in {1}")
  @MethodSource("bombs")
  void bombIsEnded(String program, Layer layer) throws IOException {
    ConfinedProcess.Limits limits =
        new ConfinedProcess.Limits(Duration.ofMillis(800), Duration.ofSeconds(60), 256);
    boolean floods = program.equals("endless_output.py");
    try (ConfinedProcess process = builder(BOMBS.resolve(program), layer).limits(limits).start()) {
      ConfinedProcess.Termination end = process.await();
      if (!floods || end.cause() != ConfinedProcess.Cause.OUTPUT) {
        assertEquals(ConfinedProcess.Cause.WALL_TIME, end.cause(), process.standardError());
      }
      assertTrue(process.standardError().length() < 70_000);
    }
  }

  private ConfinedProcess.Builder builder(Path program, Layer layer) throws IOException {
    ConfinedProcess.Builder builder =
        ConfinedProcess.on(TestEnvironment.PYTHON)
            .script(program)
            .workFolder(Files.createDirectory(folder.resolve("work")))
            .confinement(
                layer.name().startsWith("BUBBLEWRAP")
                    ? Confinement.BUBBLEWRAP
                    : Confinement.AUDIT_HOOKS);
    if (layer.name().endsWith("WITHOUT_HOOKS")) {
      builder.withoutHooks();
    }
    return layer == Layer.AUDIT_HOOKS_ALONE ? builder.withoutKernel() : builder;
  }

  private Path outside() throws IOException {
    Path outside = Files.createDirectory(folder.resolve("outside"));
    Files.writeString(outside.resolve("canary.txt"), "alive");
    return outside;
  }

  private static Map<String, String> state(Path outside) throws IOException {
    Map<String, String> state = new java.util.TreeMap<>();
    try (Stream<Path> files = Files.list(outside)) {
      for (Path file : files.toList()) {
        String mode = PosixFilePermissions.toString(Files.getPosixFilePermissions(file));
        String content =
            Files.isRegularFile(file)
                ? Files.readString(file, StandardCharsets.ISO_8859_1)
                : "no regular file";
        state.put(file.getFileName().toString(), mode + " " + content);
      }
    }
    return state;
  }
}
