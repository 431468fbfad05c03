package dev.eventchain.pipeline.start;

import dev.eventchain.check.ChainModel;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.FileRules;
import dev.eventchain.diagnostics.ResourceText;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.jsonmodels.Modeled;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.RosDistribution;
import dev.eventchain.messages.RosNames;
import dev.eventchain.model.Signal;
import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.pipeline.files.SourceFile;
import dev.eventchain.project.OpenQuestions;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.ProjectLayout;
import dev.eventchain.project.ProjectSettings;
import dev.eventchain.project.Requirements;
import dev.eventchain.project.SoftwareBase;
import dev.eventchain.xmi.XmiStore;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.stream.Stream;

/**
 * Creates a project: a small one that runs immediately, or one around existing software, with a
 * bench from its signals, and the chain from its component descriptions if these are complete.
 */
public final class ProjectStart {

  private static final String MODELS =
      """
      models:
        model: direct # made from chain.json without a language model; name one to have it modelled as in the paper
      """;

  /** Files of {@code examples/radar-aeb}, which are in the jar. */
  static final List<String> STARTER =
      List.of(
          ProjectLayout.BENCH,
          ProjectLayout.CONFIGURATION,
          ProjectLayout.MODEL,
          ProjectLayout.MUTANTS,
          ProjectLayout.REQUIREMENTS,
          "scenarios/short-sight.yaml",
          "scenarios/stopped-vehicle-50.yaml",
          ProjectLayout.COMPONENTS,
          "software-base/components/Brake_Request.py",
          "software-base/components/Collision_Warning.py",
          "software-base/components/Radar_Tracking.py",
          "software-base/msg/demo_msgs/msg/BrakeRequest.msg",
          "software-base/msg/demo_msgs/msg/RadarTarget.msg",
          "software-base/msg/demo_msgs/msg/Threat.msg",
          ProjectLayout.SIGNALS,
          "tests/Brake_Request.yaml",
          "tests/Collision_Warning.yaml",
          "tests/Radar_Tracking.yaml");

  /**
   * The content of the new project.
   *
   * @param files the written files, relative to the folder
   * @param unfed the reason why there is no chain although there are components: one of them reads
   *     a topic that nobody writes, so that design is incomplete; empty otherwise
   * @param questions findings about what is not known of existing software
   */
  public record Started(List<String> files, Optional<String> unfed, List<Diagnostic> questions) {}

  private final Path folder;
  private final BenchProposal bench;
  private final Map<String, Double> rates;
  private Optional<String> unfed = Optional.empty();

  private ProjectStart(Path folder, BenchProposal bench, Map<String, Double> rates) {
    this.folder = folder;
    this.bench = bench;
    this.rates = rates;
  }

  /** Proposes {@code bench.yaml}. */
  @FunctionalInterface
  public interface BenchProposal {

    /**
     * Returns the text of the file.
     *
     * @param signals the signals of the software base
     * @param messages the definitions of their types
     * @param rates the known rates of topics in Hz, by their full names
     */
    String text(List<Signal> signals, MessageCatalog messages, Map<String, Double> rates);
  }

  /**
   * Writes the missing files of a project.
   *
   * @param folder the folder: empty, missing, or with {@code software-base/signals.json}
   * @param bench connects the signals of a software base with the simulated world
   * @throws DiagnosticException INPUT if it is a project already ({@code project.exists}), contains
   *     other files ({@code project.foreign}), has unreadable signals, or cannot be written
   */
  public static Started create(Path folder, BenchProposal bench) {
    return new ProjectStart(folder, bench, Map.of()).create();
  }

  /**
   * Writes a project around existing software into a new or empty folder.
   *
   * @param software the texts of the files of its software base, by their paths in it
   * @param rates the known rates of topics in Hz, by their full names
   * @throws DiagnosticException as {@link #create(Path, BenchProposal)}
   */
  static Started around(
      SortedMap<String, String> software,
      Path folder,
      BenchProposal bench,
      Map<String, Double> rates) {
    ProjectStart start = new ProjectStart(folder, bench, rates);
    if (!start.isEmpty()) {
      throw start.refused(
          StartRules.FOREIGN, "The folder is not empty.", "Name a new folder for the project.");
    }
    List<String> files = new ArrayList<>();
    software.forEach(
        (name, text) -> {
          String file = ProjectLayout.SOFTWARE_BASE + "/" + name;
          start.write(file, text);
          files.add(file);
        });
    Started around = start.create();
    files.addAll(around.files());
    return new Started(files, around.unfed(), OpenQuestions.read(new ProjectFolder(folder)));
  }

  private Started create() {
    if (exists(ProjectLayout.CONFIGURATION)) {
      throw refused(StartRules.EXISTS, "This is already a project.", "Run it: eventchain run DIR");
    }
    Map<String, String> files = new LinkedHashMap<>();
    if (exists(ProjectLayout.SIGNALS)) {
      aroundSoftware(files);
    } else if (isEmpty()) {
      STARTER.forEach(name -> files.put(name, starter(name)));
    } else {
      throw refused(
          StartRules.FOREIGN,
          "The folder is not empty, but has no software-base/signals.json.",
          "Name a new folder, or describe your signals there first.");
    }
    List<String> written = new ArrayList<>();
    files.forEach(
        (name, text) -> {
          if (!exists(name)) {
            write(name, text);
            written.add(name);
          }
        });
    return new Started(written, unfed, List.of());
  }

  private boolean exists(String name) {
    return Files.exists(folder.resolve(name), LinkOption.NOFOLLOW_LINKS);
  }

  private boolean isEmpty() {
    if (!Files.exists(folder, LinkOption.NOFOLLOW_LINKS)) {
      return true;
    }
    try (Stream<Path> files = Files.list(folder)) {
      return files.findAny().isEmpty();
    } catch (IOException e) {
      throw FileRules.refusal("The folder", folder, e);
    }
  }

  private void aroundSoftware(Map<String, String> files) {
    SoftwareBase base = software(files);
    Path messages = folder.resolve(ProjectLayout.MESSAGES);
    MessageCatalog catalog =
        MessageCatalog.of(Files.isDirectory(messages) ? List.of(messages) : List.of());
    String name = name();
    files.put(ProjectLayout.CONFIGURATION, "name: " + name + "\n" + MODELS);
    Requirements requirements = requirements(files);
    if (!exists(ProjectLayout.MODEL) && !base.components().isEmpty()) {
      EventChain chain = chain(name, requirements, base);
      unfed = unfed(chain, base);
      if (unfed.isEmpty()) {
        files.put(ProjectLayout.MODEL, new String(XmiStore.toBytes(chain), StandardCharsets.UTF_8));
      }
    }
    List<Signal> signals = base.signals().orElse(List.of());
    String connections = bench.text(signals, catalog, rates);
    files.put(ProjectLayout.BENCH, connections);
    if (!exists(ProjectLayout.SCENARIOS)) {
      FirstScenario first = FirstScenario.of(requirements, signals, connections);
      files.put(ProjectLayout.SCENARIOS + "/" + first.name() + ".yaml", first.text());
    }
  }

  /** Returns the folder's name as the name of a ROS 2 package. */
  private String name() {
    String plain =
        folder
            .toAbsolutePath()
            .normalize()
            .getFileName()
            .toString()
            .toLowerCase(Locale.ROOT)
            .replaceAll("[^a-z0-9]+", "_")
            .replaceAll("^[^a-z]+", "");
    return plain.isEmpty() ? "chain" : plain;
  }

  private Requirements requirements(Map<String, String> files) {
    String name = ProjectLayout.REQUIREMENTS;
    if (exists(name)) {
      return ProjectFolder.readRules(folder.resolve(name));
    }
    String text = "# Requirements\n- REQ-1: The system shall ...\n";
    files.put(name, text);
    return Requirements.read(SourceText.of(name, text));
  }

  /** Returns the chain of the described components, which people edit from then on. */
  private EventChain chain(String name, Requirements requirements, SoftwareBase base) {
    ProjectSettings settings =
        new ProjectSettings(name, ProjectSettings.DEFAULT_FREQUENCY, RosDistribution.DEFAULT);
    Modeled<EventChain> chain =
        ChainModel.ofDescription(
            folder.resolve(ProjectLayout.COMPONENTS), settings, requirements, base);
    if (Diagnostic.anyError(chain.diagnostics())) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, chain.diagnostics());
    }
    return chain.root();
  }

  /**
   * Returns the component that reads a topic without a writing component or a signal, if there is
   * one.
   */
  private static Optional<String> unfed(EventChain chain, SoftwareBase base) {
    Set<String> written = new HashSet<>();
    base.signals().orElse(List.of()).stream()
        .filter(signal -> signal.direction() == Signal.Direction.PROVIDED)
        .forEach(signal -> written.add(RosNames.resolve(signal.topic(), "")));
    for (SoftwareNode node : chain.getSoftware()) {
      node.getOutput().forEach(data -> TopicIndex.nameOf(data, node).ifPresent(written::add));
    }
    for (SoftwareNode node : chain.getSoftware()) {
      for (Data data : node.getInput()) {
        Optional<String> topic = TopicIndex.nameOf(data, node);
        if (topic.isPresent() && !written.contains(topic.get())) {
          return Optional.of(node.getName() + " reads " + topic.get());
        }
      }
    }
    return Optional.empty();
  }

  /** Returns the folder's software; an empty list if there are no components. */
  private SoftwareBase software(Map<String, String> files) {
    SoftwareBase base = SoftwareBase.read(folder.resolve(ProjectLayout.SOFTWARE_BASE));
    boolean withoutComponents = !exists(ProjectLayout.COMPONENTS);
    List<Diagnostic> found =
        base.diagnostics().stream()
            .filter(
                it ->
                    !withoutComponents || !it.location().file().endsWith(ProjectLayout.COMPONENTS))
            .toList();
    if (Diagnostic.anyError(found)) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, found);
    }
    if (withoutComponents) {
      files.put(ProjectLayout.COMPONENTS, "[]\n");
    }
    return base;
  }

  private static String starter(String name) {
    return ResourceText.of(ProjectStart.class, "/META-INF/eventchain/starter/" + name);
  }

  private void write(String name, String text) {
    Path file = folder.resolve(name);
    for (Path parent = file.getParent(); !parent.equals(folder); parent = parent.getParent()) {
      if (Files.isSymbolicLink(parent)) {
        throw refused(
            StartRules.FOREIGN,
            folder.relativize(parent) + " is a link that leads elsewhere.",
            "Replace it with a folder: nothing is written outside the project.");
      }
    }
    try {
      Files.createDirectories(file.getParent());
      Files.writeString(file, text, StandardOpenOption.CREATE_NEW);
    } catch (IOException e) {
      throw SourceFile.unwritable(file, e);
    }
  }

  private DiagnosticException refused(Rule rule, String message, String hint) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.of(rule, message, SourceLocation.of(folder)).withHint(hint));
  }
}
