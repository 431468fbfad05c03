package dev.eventchain.lsp.project;

import dev.eventchain.check.ChainModel;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.UnsavedTexts;
import dev.eventchain.editing.FileRange;
import dev.eventchain.editing.TextLines;
import dev.eventchain.editing.TextPosition;
import dev.eventchain.editing.TextRange;
import dev.eventchain.editing.Workspace;
import dev.eventchain.lsp.text.OpenTexts;
import dev.eventchain.model.EventChainMetamodel;
import dev.eventchain.model.Signal;
import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.pipeline.campaign.plan.FactorPaths;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.ProjectLayout;
import dev.eventchain.project.SoftwareBase;
import dev.eventchain.project.ValueNames;
import dev.eventchain.xmi.LoadedModel;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.BiFunction;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** The files of a project that may name its requirements, with the texts that are open. */
final class ProjectFiles {

  private static final Set<String> ENDINGS = Set.of("yaml", "yml", "md", "json", "xmi", "ocl");

  private static final Pattern NAME = Pattern.compile("(?m)^name: *([\\w-]+)");
  private static final Pattern TITLE = Pattern.compile("(?m)^title: *(.+?) *$");

  private final Workspace workspace;
  private final OpenTexts texts;
  private final ProjectFolder folder;

  ProjectFiles(Workspace workspace, OpenTexts texts, ProjectFolder folder) {
    this.workspace = workspace;
    this.texts = texts;
    this.folder = folder;
  }

  /** Returns the requirements as they are written now; none if they cannot be read. */
  List<WrittenRequirement> requirements() {
    return known(() -> folder.hasRequirements() ? folder.readRequirements().items() : null)
        .orElse(List.of());
  }

  /** Returns the components of the software base and of the chain, with their descriptions. */
  Map<String, String> components() {
    Map<String, String> found = new TreeMap<>();
    Stream.concat(
            base().stream().flatMap(each -> each.descriptions().stream()),
            chain().stream().flatMap(each -> each.getSoftware().stream()))
        .filter(each -> each.getName() != null)
        .forEach(
            each ->
                found.putIfAbsent(
                    each.getName(), Objects.requireNonNullElse(each.getDescription(), "")));
    return found;
  }

  /** Returns a component as the chain has it, or else the software base. */
  Optional<SoftwareNode> component(String name) {
    return Stream.concat(
            chain().stream().flatMap(each -> each.getSoftware().stream()),
            base().stream().flatMap(each -> each.descriptions().stream()))
        .filter(each -> name.equals(each.getName()))
        .findFirst();
  }

  /** Returns the paths of the components in the chain, as findings name elements. */
  Map<String, String> elements() {
    return ofChain(
            (chain, model) -> {
              Map<String, String> found = new LinkedHashMap<>();
              for (SoftwareNode each : chain.getSoftware()) {
                String about = Objects.requireNonNullElse(each.getDescription(), "");
                found.put(model.origins().locate(each).element(), about);
              }
              return found;
            })
        .orElse(Map.of());
  }

  /** Returns the topics of the software base and of the chain, with what is known of them. */
  Map<String, String> topics() {
    Map<String, String> found = new TreeMap<>();
    signals().forEach(each -> found.put(each.topic(), SignalTexts.about(each)));
    chain()
        .ifPresent(
            chain ->
                TopicIndex.of(chain).topics().forEach(each -> found.putIfAbsent(each.name(), "")));
    return found;
  }

  /** Returns the fields of topics as formulas name them, with what is known of them. */
  Map<String, String> fields() {
    Map<String, String> found = new TreeMap<>();
    signals().forEach(each -> found.putAll(SignalTexts.fields(each)));
    return found;
  }

  /** Returns the described fields of a topic, with their types and units. */
  Map<String, String> fieldsOf(String topic) {
    return signals().stream()
        .filter(each -> each.topic().equals(topic))
        .findFirst()
        .map(SignalTexts::fieldsOf)
        .orElse(Map.of());
  }

  /** Returns the unit of a topic's field; empty if it is not stated. */
  String unit(String topic, String path) {
    return signals().stream()
        .filter(each -> each.topic().equals(topic))
        .flatMap(each -> each.fields().stream())
        .filter(each -> each.path().equals(path))
        .map(Signal.Field::unit)
        .findFirst()
        .orElse("");
  }

  private List<Signal> signals() {
    return base().flatMap(SoftwareBase::signals).orElse(List.of());
  }

  /** Returns the names of the values of a topic's field; none if it has none. */
  List<String> valueNames(String topic, String path) {
    return known(() -> ValueNames.of(folder).of(topic, path)).orElse(List.of());
  }

  /** Returns the scenarios, with their titles. */
  Map<String, String> scenarios() {
    Map<String, String> found = new TreeMap<>();
    scenarioTexts()
        .forEach(
            (name, text) -> {
              Matcher title = TITLE.matcher(text.text());
              found.put(name, title.find() ? title.group(1) : "");
            });
    return found;
  }

  private Map<String, SourceText> scenarioTexts() {
    Map<String, SourceText> found = new TreeMap<>();
    for (Path file : files()) {
      if (file.startsWith(folder.folder().resolve(ProjectLayout.SCENARIOS))) {
        workspace
            .text(file)
            .ifPresent(
                text -> {
                  Matcher name = NAME.matcher(text.text());
                  if (name.find()) {
                    found.put(name.group(1), text);
                  }
                });
      }
    }
    return found;
  }

  /**
   * Returns the paths of the numbers that factors of a campaign may vary, with what they are now.
   *
   * @param file that of the campaign
   * @param scenario the name of its scenario, or the path of one from there, which may be in
   *     OpenSCENARIO XML
   */
  Map<String, String> factorPaths(Path file, String scenario) {
    Optional<Path> named = beside(file, scenario);
    Optional<SourceText> played =
        named.filter(it -> scenario.matches(".*\\.ya?ml")).flatMap(workspace::text);
    Map<String, String> found = new LinkedHashMap<>();
    named.ifPresent(it -> found.putAll(FactorPaths.ofPlayed(it)));
    played
        .or(() -> Optional.ofNullable(scenarioTexts().get(scenario)))
        .ifPresent(text -> found.putAll(FactorPaths.ofScenario(text)));
    if (!found.isEmpty()) {
      components().keySet().forEach(each -> found.putIfAbsent("phases_ms." + each, ""));
      bench().ifPresent(text -> found.putAll(FactorPaths.ofBench(text)));
    }
    return found;
  }

  private Optional<SourceText> bench() {
    Path file = folder.folder().resolve(ProjectLayout.BENCH);
    return Files.isRegularFile(file) ? workspace.text(file) : Optional.empty();
  }

  /** Returns the file of the project that another one names. */
  private Optional<Path> beside(Path file, String name) {
    try {
      Path named = file.resolveSibling(name).normalize();
      return Optional.of(named)
          .filter(it -> it.startsWith(folder.folder()) && Files.isRegularFile(it));
    } catch (InvalidPathException e) {
      return Optional.empty(); // no path on this system
    }
  }

  private Optional<SoftwareBase> base() {
    return known(folder::readSoftwareBase);
  }

  private Optional<EventChain> chain() {
    return ofChain((chain, model) -> chain);
  }

  private <T> Optional<T> ofChain(BiFunction<EventChain, LoadedModel, T> asked) {
    return folder
        .model(folder.defaultOutput())
        .flatMap(
            file ->
                known(
                    () -> {
                      LoadedModel model =
                          EventChainMetamodel.store(file.resolveSibling("")).load(file);
                      return asked.apply(ChainModel.chainOf(model, file), model);
                    }));
  }

  /** Returns what the texts that are open say; empty if they cannot be read. */
  private <T> Optional<T> known(Supplier<T> reading) {
    try {
      return Optional.ofNullable(UnsavedTexts.during(texts.overlay(), reading));
    } catch (DiagnosticException e) {
      return Optional.empty(); // a finding says why
    }
  }

  /** Returns where a requirement is written. */
  Optional<FileRange> place(WrittenRequirement requirement) {
    SourceLocation location = requirement.location();
    Path file = Path.of(location.file());
    return uses(requirement.id(), List.of(file)).stream()
        .filter(each -> each.range().start().line() + 1 == location.line())
        .findFirst();
  }

  /**
   * Returns where a scenario, a component or a topic has its name: in its file, in the description
   * of the software base, or else in the chain.
   */
  Optional<FileRange> declaration(String name) {
    return signals().stream()
        .filter(each -> each.topic().equals(name))
        .findFirst()
        .flatMap(each -> place(name, each.location()))
        .or(() -> uses(name, declaring()).stream().filter(this::isDeclared).findFirst());
  }

  private List<Path> declaring() {
    Path scenarios = folder.folder().resolve(ProjectLayout.SCENARIOS);
    List<Path> files =
        new ArrayList<>(files().stream().filter(each -> each.startsWith(scenarios)).toList());
    Stream.of(Optional.of(folder.componentsFile()), folder.model(folder.defaultOutput()))
        .flatMap(Optional::stream)
        .filter(Files::isRegularFile)
        .forEach(files::add);
    return files;
  }

  /** Returns where a signal has its name, or else where its description begins. */
  private Optional<FileRange> place(String name, SourceLocation location) {
    if (location.file().isEmpty() || !Files.isRegularFile(Path.of(location.file()))) {
      return Optional.empty();
    }
    Path file = Path.of(location.file());
    int line = Math.max(0, location.line() - 1);
    TextPosition start = new TextPosition(line, Math.max(0, location.column() - 1));
    return uses(name, List.of(file)).stream()
        .filter(each -> each.range().start().line() >= line)
        .findFirst()
        .or(() -> Optional.of(new FileRange(file, TextRange.at(start))));
  }

  /** Returns whether a name stands behind the key or the attribute of names. */
  private boolean isDeclared(FileRange use) {
    String text = workspace.text(use.file()).map(SourceText::text).orElse("");
    String before = text.substring(0, new TextLines(text).offset(use.range().start()));
    String line = before.substring(before.lastIndexOf('\n') + 1);
    return line.matches("(.*[\\s{,])?(name: *[\"']?|\"(name|topic)\" *: *\"|name=\"|topicName=\")");
  }

  /** Returns all places at which the project names something, in the order of the files. */
  List<FileRange> uses(String id) {
    return uses(id, files());
  }

  private List<FileRange> uses(String id, List<Path> files) {
    // An id may go on after a dot, unlike a sentence that ends with one; a topic has fields there.
    String after = id.startsWith("/") ? "(?![\\w/-])" : "(?![\\w-]|\\.\\w)";
    Pattern word = Pattern.compile("(?<![\\w-]|\\w\\.)" + Pattern.quote(id) + after);
    List<FileRange> found = new ArrayList<>();
    for (Path file : files) {
      Optional<String> text = workspace.text(file).map(SourceText::text);
      if (text.isPresent() && text.get().contains(id)) {
        TextLines lines = new TextLines(text.get());
        Matcher matcher = word.matcher(text.get());
        while (matcher.find()) {
          found.add(new FileRange(file, lines.range(matcher.start(), matcher.end())));
        }
      }
    }
    return found;
  }

  private List<Path> files() {
    return ProjectWalk.files(folder).stream().filter(ProjectFiles::isText).toList();
  }

  private static boolean isText(Path file) {
    String name = file.getFileName().toString();
    return ENDINGS.contains(name.substring(name.lastIndexOf('.') + 1)) && Files.isRegularFile(file);
  }

  /** Returns whether requirements are kept in a file of ours, which may be changed. */
  boolean owns(WrittenRequirement requirement) {
    return Path.of(requirement.location().file()).endsWith(ProjectLayout.REQUIREMENTS);
  }

  /** Returns what kind of file of the project one is, if a schema describes it. */
  Optional<ProjectSchemas.Kind> kind(Path file, String text) {
    return ProjectSchemas.kind(folder.folder(), file, text);
  }

  /** Returns a file of the project as people name it. */
  String name(Path file) {
    return folder.folder().relativize(file).toString();
  }
}
