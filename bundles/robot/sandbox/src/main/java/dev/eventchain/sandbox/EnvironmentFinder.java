package dev.eventchain.sandbox;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.Sha256;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;

/**
 * Finds the environment that {@code environment.py} creates. The cache maps each Python to its
 * environment, so that usually no Python has to be started.
 */
final class EnvironmentFinder {

  private static final String RESOURCES = "dev/eventchain/sandbox";
  private static final String SCRIPT = "environment.py";
  private static final List<String> PLAIN = List.of(SCRIPT, "requirements.txt");
  private static final List<String> WITH_CYCLONEDDS =
      List.of(SCRIPT, "requirements.txt", "requirements-cyclonedds.txt");
  private static final List<String> WITH_RAY = List.of(SCRIPT, "requirements-ray.txt");
  private static final Map<Integer, Rule> RULES =
      Map.of(
          4, PythonRules.DDS_UNAVAILABLE,
          5, PythonRules.PYTHON_WHEELS_MISSING,
          6, PythonRules.RAY_UNAVAILABLE);
  private static final List<String> NAMES =
      List.of("python3", "python3.13", "python3.12", "python3.11", "python3.10", "python3.14");
  private static final String CHECK = "Name a Python that can be started in EVENTCHAIN_PYTHON.";
  private static final String MARKER = "complete.txt";

  private final Map<String, String> settings;
  private final Consumer<String> progress;

  EnvironmentFinder(Map<String, String> settings, Consumer<String> progress) {
    this.settings = settings;
    this.progress = progress;
  }

  PythonEnvironment find() {
    return find(PLAIN, List.of());
  }

  PythonEnvironment findWithCycloneDds() {
    return find(WITH_CYCLONEDDS, List.of("--cyclonedds"));
  }

  PythonEnvironment findWithRay() {
    return find(WITH_RAY, List.of("--ray"));
  }

  /**
   * Returns the version of Python and its packages that {@link #find} would use, without creating
   * the environment.
   */
  String outlook() {
    return ask(python(), List.of("--check"));
  }

  String outlookWithCycloneDds() {
    return ask(python(), List.of("--cyclonedds", "--check"));
  }

  private PythonEnvironment find(List<String> content, List<String> options) {
    Path python = python();
    Path remembered = CacheFolder.of(settings).resolve("python-of-" + key(python, content));
    return recall(remembered).orElseGet(() -> create(python, options, remembered));
  }

  private Path python() {
    String chosen = settings.getOrDefault("EVENTCHAIN_PYTHON", "");
    List<String> names = chosen.isEmpty() ? NAMES : List.of(chosen);
    for (String name : names) {
      for (String folder : settings.getOrDefault("PATH", "").split(":", -1)) {
        Path candidate = Path.of(folder).resolve(name);
        if (Files.isRegularFile(candidate) && Files.isExecutable(candidate)) {
          return candidate.toAbsolutePath();
        }
      }
    }
    if (!chosen.isEmpty()) {
      throw unavailable(
          SourceLocation.of(Path.of(chosen)),
          "EVENTCHAIN_PYTHON names " + chosen + ", which is not an executable file.",
          "Set it to a Python 3.10 or newer, or unset it to use the python3 on the PATH.");
    }
    throw unavailable(
        SourceLocation.NONE,
        "There is no python3 on the PATH.",
        "Install Python 3.10 or newer, or set EVENTCHAIN_PYTHON to one.");
  }

  /** Returns a cache key that changes with the pins or the installed Python. */
  private String key(Path python, List<String> content) {
    Sha256 digest = new Sha256();
    try {
      for (String name : content) {
        try (InputStream input = getClass().getResourceAsStream(name)) {
          digest.add(input.readAllBytes());
        }
      }
      Path real = python.toRealPath();
      String facts =
          String.join(
              "\0",
              python.toString(),
              real.toString(),
              Long.toString(Files.size(real)),
              Files.getLastModifiedTime(real).toString(),
              settings.getOrDefault("PYENV_VERSION", ""));
      digest.add(facts);
    } catch (IOException e) {
      throw unavailable(
          SourceLocation.of(python), "Python cannot be read: " + SourceText.reason(e) + ".", CHECK);
    }
    return digest.abbreviated();
  }

  private static Optional<PythonEnvironment> recall(Path remembered) {
    try {
      return Optional.of(open(Path.of(Files.readString(remembered).strip())));
    } catch (IOException e) {
      return Optional.empty();
    }
  }

  private static PythonEnvironment open(Path folder) throws IOException {
    Path executable = folder.resolve("bin/python");
    String version = "";
    Optional<Path> cycloneDds = Optional.empty();
    Set<Path> installation = new LinkedHashSet<>();
    for (String line : Files.readAllLines(folder.resolve(MARKER))) {
      String value = line.substring(line.indexOf('=') + 1);
      if (line.startsWith("version=")) {
        version = value;
      } else if (line.startsWith("cyclonedds=")) {
        cycloneDds = Optional.of(Path.of(value));
      } else {
        installation.add(Path.of(value));
      }
    }
    if (!Files.isExecutable(executable)) {
      throw new IOException("the Python that the environment uses is gone");
    }
    installation.add(folder);
    installation.addAll(links(executable));
    return new PythonEnvironment(folder, version, List.copyOf(installation), cycloneDds);
  }

  /** Returns the symbolic links between the environment's Python and the executed file. */
  private static List<Path> links(Path executable) throws IOException {
    List<Path> links = new ArrayList<>();
    Path current = executable;
    while (Files.isSymbolicLink(current)) {
      current = current.resolveSibling(Files.readSymbolicLink(current)).normalize();
      links.add(current);
    }
    return links;
  }

  private PythonEnvironment create(Path python, List<String> options, Path remembered) {
    List<String> wanted = new ArrayList<>(options);
    wanted.add("--print-executable");
    Path executable = Path.of(ask(python, wanted)).toAbsolutePath();
    if (!Files.isExecutable(executable) || Files.isDirectory(executable)) {
      throw unavailable(
          SourceLocation.of(python),
          python + " is not Python: it named no program that can be started.",
          "Name a Python 3.10 or later in EVENTCHAIN_PYTHON, or unset it.");
    }
    try {
      PythonEnvironment found = open(executable.getParent().getParent());
      remember(remembered, executable.getParent().getParent());
      return found;
    } catch (IOException e) {
      throw unavailable(
          SourceLocation.of(executable),
          "The Python environment cannot be read: " + SourceText.reason(e) + ".",
          "Remove " + executable.getParent().getParent() + "; it is created again.");
    }
  }

  private static void remember(Path remembered, Path folder) throws IOException {
    Path unfinished = Files.createTempFile(remembered.getParent(), "python-of-", ".new");
    Files.writeString(unfinished, folder + "\n");
    Files.move(unfinished, remembered, StandardCopyOption.ATOMIC_MOVE);
  }

  private String ask(Path python, List<String> options) {
    Path script = PythonSources.unpack(getClass().getClassLoader(), RESOURCES).resolve(SCRIPT);
    List<String> command = new ArrayList<>(List.of(python.toString(), script.toString()));
    command.addAll(options);
    return run(python, command);
  }

  private String run(Path python, List<String> command) {
    ProcessBuilder builder = new ProcessBuilder(command);
    builder.environment().clear();
    builder.environment().putAll(settings);
    builder.redirectErrorStream(true);
    Answer answer = new Answer();
    int exitCode;
    try {
      Process process = builder.start();
      process.getOutputStream().close();
      try (BufferedReader lines = process.inputReader(StandardCharsets.UTF_8)) {
        lines.lines().forEach(answer::take);
      }
      exitCode = process.waitFor();
    } catch (IOException | UncheckedIOException e) {
      IOException cause = e instanceof UncheckedIOException u ? u.getCause() : (IOException) e;
      String reason = SourceText.reason(cause);
      throw unavailable(
          SourceLocation.of(python), "Python cannot be started: " + reason + ".", CHECK);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw unavailable(
          SourceLocation.of(python), "Creating the Python environment was interrupted.", "");
    }
    if (exitCode != 0) {
      Rule rule = RULES.getOrDefault(exitCode, PythonRules.PYTHON_UNAVAILABLE);
      throw unavailable(rule, SourceLocation.of(python), answer.problem(exitCode), answer.hint);
    }
    return answer.last;
  }

  /** Output of {@code environment.py}: progress, problem and hint, and finally the result. */
  private final class Answer {
    private String error = "";
    private String hint = "";
    private String last = "";

    private void take(String line) {
      if (line.startsWith("error: ")) {
        error = line.substring("error: ".length());
      } else if (line.startsWith("hint: ")) {
        hint = line.substring("hint: ".length());
      } else if (line.startsWith("state: ")) {
        last = line.substring("state: ".length());
      } else if (line.startsWith("/")) {
        last = line;
      } else {
        last = line;
        progress.accept(line);
      }
    }

    private String problem(int exitCode) {
      return error.isEmpty() ? "environment.py ended with " + exitCode + ": " + last : error;
    }
  }

  private static DiagnosticException unavailable(
      SourceLocation place, String message, String hint) {
    return unavailable(PythonRules.PYTHON_UNAVAILABLE, place, message, hint);
  }

  private static DiagnosticException unavailable(
      Rule rule, SourceLocation place, String message, String hint) {
    return new DiagnosticException(
        DiagnosticException.Reason.UNAVAILABLE, Diagnostic.of(rule, message, place).withHint(hint));
  }
}
