package dev.eventchain.pipeline;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.ocl.OclRules;
import dev.eventchain.simulation.Bench;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.FileVisitOption;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** A user's folder: where its files are, and what its configuration says. */
public final class Project {

  private static final String DESIGN_RULES = "design-rules.md";

  private final Path folder;
  private final Configuration configuration;
  private final Optional<Sample> sample;

  private Project(Path folder, Configuration configuration, Optional<Sample> sample) {
    this.folder = folder;
    this.configuration = configuration;
    this.sample = sample;
  }

  /**
   * Opens a project.
   *
   * @param folder the folder that holds {@code eventchain.yaml}
   * @throws DiagnosticException INPUT if it is no project, or its configuration is not understood
   */
  public static Project open(Path folder) {
    Path file = folder.resolve("eventchain.yaml");
    if (!Files.isDirectory(folder)) {
      throw new DiagnosticException(
          DiagnosticException.Reason.INPUT,
          Diagnostic.error(
              "project.missing", "There is no such folder.", SourceLocation.of(folder)));
    }
    if (!Files.exists(file)) {
      throw new DiagnosticException(
          DiagnosticException.Reason.INPUT,
          Diagnostic.error(
                  "project.missing",
                  "The folder is no project: it holds no eventchain.yaml.",
                  SourceLocation.of(folder))
              .withHint("Name the folder of a project, for example examples/aeb."));
    }
    return new Project(folder, Configuration.read(SourceText.read(file), folder), Optional.empty());
  }

  /** The folder. */
  public Path folder() {
    return folder;
  }

  /** The findings that the project's people have decided to live with, if they have said any. */
  public Optional<Path> suppressions() {
    return existing("eventchain-suppressions.yaml");
  }

  /** Where a run writes if it is not told otherwise. */
  public Path defaultOutput() {
    return defaultOutput(folder);
  }

  /** As {@link #defaultOutput()}, also of a project that cannot be opened. */
  public static Path defaultOutput(Path folder) {
    return folder.resolve("out");
  }

  /** The project as a run of an evaluation sees it: one model does every task. */
  Project evaluatedBy(Sample run) {
    return new Project(folder, configuration.askingOnly(run.model()), Optional.of(run));
  }

  /** The run of an evaluation that this is for, if it is for one. */
  Optional<Sample> sample() {
    return sample;
  }

  Configuration configuration() {
    return configuration;
  }

  Path configurationFile() {
    return folder.resolve("eventchain.yaml");
  }

  Path requirements() {
    return folder.resolve("requirements.md");
  }

  /** The design rules, when there are any. */
  Optional<Path> designRules() {
    return existing(DESIGN_RULES);
  }

  Path designRulesFile() {
    return folder.resolve(DESIGN_RULES);
  }

  Path softwareBase() {
    return folder.resolve("software-base");
  }

  /** The files that describe the software base, whether they are there or not. */
  List<Path> softwareBaseFiles() {
    return List.of(
        softwareBase().resolve("components.json"), softwareBase().resolve("signals.json"));
  }

  Path recordings() {
    return folder.resolve("recordings");
  }

  /**
   * The chain that people edit, when there is one: then it is the source, unless language models
   * are evaluated, which then have a chain of their own to design.
   */
  Optional<Path> editedModel() {
    return sample.isPresent() ? Optional.empty() : existing("model/chain.xmi");
  }

  /** The model of the chain: the one that people edit, else the one that an earlier run wrote. */
  public Optional<Path> model(Path output) {
    return editedModel()
        .or(() -> Optional.of(output.resolve("chain.xmi")).filter(Files::isRegularFile));
  }

  /**
   * Whether there is a model, which people edit or an earlier run wrote, and the constraints that
   * stand for the design rules.
   *
   * @param output the folder of that run's results
   */
  public boolean isReadyToValidate(Path output) {
    boolean hasConstraints =
        designRules().isEmpty() || Files.isRegularFile(output.resolve(Constraints.GENERATED));
    return model(output).isPresent() && hasConstraints;
  }

  /** The constraints that people wrote, and those that they import. */
  List<Path> ownConstraints() {
    return OclRules.files(existing("constraints.ocl").stream().toList());
  }

  /** Folders that hold {@code <package>/msg/*.msg}. */
  List<Path> messageFolders() {
    Optional<Path> messages = existing("software-base/msg");
    messages.filter(each -> !Files.isDirectory(each)).ifPresent(Project::refuseNoFolder);
    return messages.map(List::of).orElse(List.of());
  }

  /** The files in the folders of messages. */
  List<Path> messageFiles() {
    return messageFolders().stream().flatMap(folder -> below(folder).stream()).toList();
  }

  /** The files in a folder and in those below it, but for what Python has compiled. */
  static List<Path> below(Path folder) {
    try (Stream<Path> files = Files.walk(folder, FileVisitOption.FOLLOW_LINKS)) {
      return files
          .filter(file -> Files.isRegularFile(file) || isLinkToNothing(file))
          .filter(file -> !file.toString().contains("__pycache__"))
          .sorted()
          .toList();
    } catch (IOException e) {
      throw unreadable(folder, e);
    } catch (UncheckedIOException e) {
      throw unreadable(folder, e.getCause());
    }
  }

  /** As {@link #below}, none where there is no such folder. */
  static List<Path> existingBelow(Path folder) {
    return Files.isDirectory(folder) ? below(folder) : List.of();
  }

  private static boolean isLinkToNothing(Path file) {
    return Files.isSymbolicLink(file) && !Files.exists(file);
  }

  /** How the world and the chain are connected, where the project says so itself. */
  Optional<Path> bench() {
    return existing(Bench.FILE);
  }

  /** The folder of the scenarios. */
  Path scenarios() {
    return folder.resolve("scenarios");
  }

  /** Everything that people wrote and a run may read, but for recordings and the chain. */
  List<Path> sources() {
    List<Path> files = new ArrayList<>(List.of(requirements(), designRulesFile()));
    files.addAll(ownConstraints());
    bench().ifPresent(files::add);
    for (String name : List.of("software-base", "scenarios", "tests")) {
      existing(name).filter(Files::isDirectory).ifPresent(each -> files.addAll(below(each)));
    }
    files.addAll(Templates.ownFiles(this));
    return files;
  }

  private Optional<Path> existing(String name) {
    return Optional.of(folder.resolve(name)).filter(file -> !isAbsent(file));
  }

  /**
   * Whether there is certainly nothing of this name. A link to nothing, a folder, and what may not
   * be looked at are there: reading them says what is wrong.
   */
  static boolean isAbsent(Path file) {
    return Files.notExists(file, LinkOption.NOFOLLOW_LINKS);
  }

  private static void refuseNoFolder(Path path) {
    throw unreadable(path, new NotDirectoryException(path.toString()));
  }

  /** The failure that a file or folder of the project cannot be read. */
  static DiagnosticException unreadable(Path path, IOException e) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.error(
                "file.unreadable",
                "This cannot be read: " + SourceText.reason(e) + ".",
                SourceLocation.of(path))
            .withHint("Check that it is there and that you may read it."));
  }
}
