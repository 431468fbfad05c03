package dev.eventchain.sandbox;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** The command line of a confined process: bubblewrap (where used), Python, and confined.py. */
final class ConfinedCommand {

  private static final ObjectMapper JSON = new ObjectMapper();
  private static final String START =
      "import sys; sys.path.insert(0, sys.argv[1]); import confined; confined.main(sys.argv[2])";
  private static final Pattern NUMPY =
      Pattern.compile("^[ \\t]*(?:import|from)[ \\t]+numpy\\b", Pattern.MULTILINE);
  private static final long MIB = 1024 * 1024;
  private static final long FILE_SIZE = 64 * MIB;
  private static final int OPEN_FILES = 256;

  private final PythonEnvironment environment;
  private final Path harness =
      PythonSources.unpack(ConfinedCommand.class.getClassLoader(), "dev/eventchain/sandbox");
  private final List<Path> readable = new ArrayList<>();
  private final List<Path> pythonPath = new ArrayList<>();
  private List<String> arguments = List.of();
  private String programKind = "";
  private String program = "";
  private Path workFolder;
  private ConfinedProcess.Limits limits;
  private Confinement confinement;
  private boolean kernel = true;
  private boolean hooks = true;
  private boolean components;
  private int turn;
  private int hashSeed;
  private final Set<String> modules = new HashSet<>();
  private boolean forks = true;
  private JsonNode preparation;

  ConfinedCommand(PythonEnvironment environment) {
    this.environment = environment;
  }

  void program(String kind, String name) {
    programKind = kind;
    program = name;
  }

  void arguments(List<String> values) {
    arguments = values;
  }

  void workFolder(Path folder) {
    workFolder = folder.toAbsolutePath().normalize();
  }

  void readable(Collection<Path> paths) {
    paths.forEach(path -> readable.add(path.toAbsolutePath().normalize()));
  }

  void pythonPath(Collection<Path> folders) {
    folders.forEach(folder -> pythonPath.add(folder.toAbsolutePath().normalize()));
  }

  void limits(ConfinedProcess.Limits newLimits) {
    limits = newLimits;
  }

  void confinement(Confinement chosen) {
    confinement = chosen;
  }

  void preparation(String module, JsonNode settings) {
    ObjectNode described = JSON.createObjectNode();
    described.put("module", module).set("settings", settings);
    preparation = described;
  }

  void hashSeed(int seed) {
    hashSeed = seed;
  }

  void components(int newTurn, Collection<Path> files) {
    components = true;
    turn = newTurn;
    pythonPath.add(harness);
    if (files.stream().anyMatch(ConfinedCommand::importsNumPy)) {
      modules.add("numpy");
    }
  }

  /** As {@code fork_server.py} looks for it. */
  private static boolean importsNumPy(Path file) {
    try {
      return NUMPY.matcher(Files.readString(file, StandardCharsets.ISO_8859_1)).find();
    } catch (IOException e) {
      return false; // whoever loads it reports that
    }
  }

  void withoutTemplate() {
    forks = false;
  }

  void withoutKernel() {
    kernel = false;
  }

  void withoutHooks() {
    hooks = false;
  }

  /** Returns the folder of our own sources. */
  Path harness() {
    return harness;
  }

  /** Returns the complete environment of a new interpreter. */
  Map<String, String> settings() {
    return settings(workFolder.toString(), hashSeed);
  }

  static Map<String, String> settings(String folder, int hashSeed) {
    return Map.of(
        "HOME", folder,
        "TMPDIR", folder,
        "LC_ALL", "C.UTF-8",
        "PYTHONUTF8", "1",
        "PYTHONHASHSEED", Integer.toString(hashSeed),
        "PYTHONDONTWRITEBYTECODE", "1",
        "PYTHONNOUSERSITE", "1",
        "PYTHONSAFEPATH", "1",
        "OPENBLAS_NUM_THREADS", "1");
  }

  /** Returns the command of a new interpreter. */
  List<String> line() {
    List<String> line = new ArrayList<>(enclosure());
    line.addAll(line.isEmpty() ? List.of() : List.of("--"));
    line.add(environment.executable().toString());
    line.addAll(List.of("-c", START, harness.toString(), description()));
    return line;
  }

  /** Returns the command of bubblewrap, without a program; empty if it is not used. */
  List<String> enclosure() {
    if (chosen() != Confinement.BUBBLEWRAP) {
      return List.of();
    }
    List<Path> visible = new ArrayList<>(environment.installation());
    visible.add(harness);
    visible.addAll(pythonPath);
    visible.addAll(readable);
    return Bubblewrap.command(visible, workFolder, preparation != null);
  }

  private Confinement chosen() {
    return confinement == null ? Confinement.detect() : confinement;
  }

  /** Compiles the sources ahead of time. */
  void compile() {
    Objects.requireNonNull(workFolder, "a confined process needs a work folder");
    Bytecode.compile(environment, harness);
    pythonPath.forEach(folder -> Bytecode.compile(environment, folder));
  }

  /**
   * Returns the template of such processes; empty if there cannot be one, since a preparation has
   * to come first.
   */
  Optional<Template.Kind> template() {
    return preparation == null && forks
        ? Optional.of(
            new Template.Kind(
                environment.executable(),
                harness,
                hashSeed,
                List.copyOf(pythonPath),
                Set.copyOf(modules)))
        : Optional.empty();
  }

  /** Returns the text for {@code confined.main}. */
  String description() {
    Confinement chosen = chosen();
    ObjectNode description = JSON.createObjectNode();
    description.put("work", workFolder.toString());
    description.put(programKind, program);
    addAll(description.putArray("readable"), readable.stream());
    addAll(description.putArray("path"), pythonPath.stream());
    addAll(description.putArray("arguments"), arguments.stream());
    ObjectNode amounts = description.putObject("limits");
    amounts.put("cpuSeconds", Math.max(1, limits.cpuTime().plusMillis(999).toSeconds()));
    amounts.put("memory", limits.memoryMiB() * MIB);
    amounts.put("fileSize", FILE_SIZE);
    amounts.put("openFiles", OPEN_FILES);
    description.put("enclosed", chosen == Confinement.BUBBLEWRAP);
    description.put("kernel", kernel);
    description.put("hooks", hooks);
    description.put("components", components);
    description.put("turn", turn);
    description.put("parent", ProcessHandle.current().pid());
    if (preparation != null) {
      description.set("preparation", preparation);
    }
    return description.toString();
  }

  private static void addAll(ArrayNode array, Stream<?> values) {
    values.forEach(value -> array.add(value.toString()));
  }
}
