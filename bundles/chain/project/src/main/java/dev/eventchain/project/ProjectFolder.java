package dev.eventchain.project;

import dev.eventchain.constraints.OclRules;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.messages.MessageCatalog;
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

/** A user's folder: where its files are, and those of its results that are checked. */
public class ProjectFolder {

  /** The description of the chain, among the results of a run. */
  public static final String DESCRIPTION = "chain.json";

  /** The model of the chain, among the results of a run. */
  public static final String MODEL = "chain.xmi";

  /** The constraints that stand for the design rules, among the results of a run. */
  public static final String GENERATED = "generated.ocl";

  private static final String CONFIGURATION = "eventchain.yaml";
  private static final String DESIGN_RULES = "design-rules.md";

  private final Path folder;

  /**
   * A folder, of which nothing is looked at yet.
   *
   * @param folder the folder that holds {@code eventchain.yaml}
   */
  public ProjectFolder(Path folder) {
    this.folder = folder;
  }

  /** The folder. */
  public final Path folder() {
    return folder;
  }

  /** The file by which a project is known. */
  public final Path configurationFile() {
    return folder.resolve(CONFIGURATION);
  }

  /**
   * What the configuration says.
   *
   * @throws DiagnosticException INPUT if it is not a project ({@code project.missing}), the file
   *     cannot be read, or another one is not read because of the case of its name ({@code
   *     project.file.misnamed})
   */
  public final SourceText configurationText() {
    if (!Files.isDirectory(folder)) {
      throw new DiagnosticException(
          DiagnosticException.Reason.INPUT,
          Diagnostic.error(
              "project.missing", "There is no such folder.", SourceLocation.of(folder)));
    }
    if (!Files.exists(configurationFile())) {
      throw new DiagnosticException(
          DiagnosticException.Reason.INPUT,
          Diagnostic.error(
                  "project.missing",
                  "The folder is not a project: it contains no eventchain.yaml.",
                  SourceLocation.of(folder))
              .withHint(
                  ProjectFileNames.misspelt(configurationFile())
                      .map(name -> "Rename '" + name + "' to '" + CONFIGURATION + "'.")
                      .orElse(
                          "Name the folder of a project, for example examples/aeb; 'eventchain"
                              + " init' starts one. Model files are named one by one.")));
    }
    ProjectFileNames.refuseOtherCase(folder);
    return SourceText.read(configurationFile());
  }

  /** The findings that the project's people have decided to live with, if they have said any. */
  public final Optional<Path> suppressions() {
    return existing("eventchain-suppressions.yaml");
  }

  /** Where a run writes if it is not told otherwise. */
  public final Path defaultOutput() {
    return folder.resolve("out");
  }

  /**
   * The command that runs the project.
   *
   * @param output the folder of its results
   * @param more what follows it; may be empty
   */
  public final String command(Path output, String more) {
    boolean usual = output.equals(defaultOutput());
    return "eventchain run "
        + folder
        + (usual ? "" : " -o " + output)
        + (more.isEmpty() ? "" : " " + more);
  }

  /** The functional requirements, whether they are there or not. */
  public final Path requirements() {
    return folder.resolve("requirements.md");
  }

  /** The design rules, when there are any. */
  public final Optional<Path> designRules() {
    return existing(DESIGN_RULES);
  }

  /** The design rules, whether they are there or not. */
  public final Path designRulesFile() {
    return folder.resolve(DESIGN_RULES);
  }

  /** The folder of what exists already. */
  public final Path softwareBase() {
    return folder.resolve("software-base");
  }

  /** The files that describe the software base, whether they are there or not. */
  public final List<Path> softwareBaseFiles() {
    return List.of(
        softwareBase().resolve("components.json"), softwareBase().resolve("signals.json"));
  }

  /** The chain that people edit, when there is one: then it is the source. */
  public Optional<Path> editedModel() {
    return existing("model/chain.xmi");
  }

  /** The model of the chain: the one that people edit, else the one that an earlier run wrote. */
  public final Optional<Path> model(Path output) {
    return editedModel().or(() -> Optional.of(output.resolve(MODEL)).filter(Files::isRegularFile));
  }

  /** The constraints that people wrote, and those that they import. */
  public final List<Path> ownConstraints() {
    return OclRules.files(existing("constraints.ocl").stream().toList());
  }

  /** The constraints that an earlier run has generated, when there are any. */
  public final Optional<Path> generated(Path output) {
    return Optional.of(output.resolve(GENERATED)).filter(file -> !isAbsent(file));
  }

  /**
   * The files that hold the project's constraints, but for the standard ones.
   *
   * @param output the folder of the project's results, which may hold generated constraints
   */
  public final List<Path> constraintFiles(Path output) {
    List<Path> files = new ArrayList<>(ownConstraints());
    generated(output).ifPresent(files::add);
    return files;
  }

  /** As {@link #constraintFiles}, for people. */
  public final List<String> constraintNames(Path output) {
    return constraintFiles(output).stream().map(file -> SourceLocation.of(file).file()).toList();
  }

  /** Folders that hold {@code <package>/msg/*.msg}. */
  public final List<Path> messageFolders() {
    Optional<Path> messages = existing("software-base/msg");
    messages.filter(each -> !Files.isDirectory(each)).ifPresent(ProjectFolder::refuseNoFolder);
    return messages.map(List::of).orElse(List.of());
  }

  /** The files in the folders of messages. */
  public final List<Path> messageFiles() {
    return messageFolders().stream().flatMap(each -> below(each).stream()).toList();
  }

  /**
   * Reads requirements or design rules.
   *
   * @throws DiagnosticException INPUT if the file cannot be read, or with its findings if one is an
   *     error
   */
  public static Requirements readRules(Path file) {
    Requirements read = Requirements.read(SourceText.read(file));
    refuseErrors(read.diagnostics());
    return read;
  }

  /**
   * Reads what exists already.
   *
   * @throws DiagnosticException INPUT with what is found if it is an error
   */
  public final SoftwareBase readSoftwareBase() {
    SoftwareBase base = SoftwareBase.read(softwareBase());
    refuseErrors(base.diagnostics());
    return base;
  }

  /**
   * Reads the message definitions, the standard ones and the project's own.
   *
   * @throws DiagnosticException INPUT with what is found if it is an error
   */
  public final MessageCatalog readMessages() {
    MessageCatalog messages = MessageCatalog.of(messageFolders());
    refuseErrors(messages.diagnostics());
    return messages;
  }

  private static void refuseErrors(List<Diagnostic> diagnostics) {
    if (Diagnostic.anyError(diagnostics)) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, diagnostics);
    }
  }

  /** The files in a folder and in those below it, but for what Python has compiled. */
  public static List<Path> below(Path folder) {
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

  private static boolean isLinkToNothing(Path file) {
    return Files.isSymbolicLink(file) && !Files.exists(file);
  }

  /** A file or folder of the project, unless there certainly is none of this name. */
  protected final Optional<Path> existing(String name) {
    return Optional.of(folder.resolve(name)).filter(file -> !isAbsent(file));
  }

  /**
   * Whether there is certainly nothing of this name. A link to nothing, a folder, and what may not
   * be looked at are there: reading them says what is wrong.
   */
  public static boolean isAbsent(Path file) {
    return Files.notExists(file, LinkOption.NOFOLLOW_LINKS);
  }

  private static void refuseNoFolder(Path path) {
    throw unreadable(path, new NotDirectoryException(path.toString()));
  }

  /** The failure that a file or folder of the project cannot be read. */
  public static DiagnosticException unreadable(Path path, IOException e) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.error(
                "file.unreadable",
                "This cannot be read: " + SourceText.reason(e) + ".",
                SourceLocation.of(path))
            .withHint("Check that it exists and that you may read it."));
  }
}
