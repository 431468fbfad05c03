package dev.eventchain.lsp.project;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.editing.Analysis;
import dev.eventchain.editing.Call;
import dev.eventchain.editing.Completion;
import dev.eventchain.editing.ElementKind;
import dev.eventchain.editing.FileEdit;
import dev.eventchain.editing.FileRange;
import dev.eventchain.editing.Folding;
import dev.eventchain.editing.Hover;
import dev.eventchain.editing.InlayHint;
import dev.eventchain.editing.Rename;
import dev.eventchain.editing.RenameTarget;
import dev.eventchain.editing.SemanticToken;
import dev.eventchain.editing.SignatureHelp;
import dev.eventchain.editing.Symbol;
import dev.eventchain.editing.TextLines;
import dev.eventchain.editing.TextPosition;
import dev.eventchain.editing.TextRange;
import dev.eventchain.model.WrittenRequirement;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * A text of a project: its outline by keys or requirements, and what is known of the requirements
 * that it names.
 */
final class ProjectText implements Analysis {

  private static final Pattern ID = Pattern.compile("[A-Za-z0-9][\\w.-]*");

  /** The kinds of files that have formulas. */
  private static final Set<ProjectSchemas.Kind> FORMULAS =
      EnumSet.of(
          ProjectSchemas.Kind.SCENARIO, ProjectSchemas.Kind.CAMPAIGN, ProjectSchemas.Kind.BENCH);

  /** The end of a requirement in Markdown. */
  private static final Pattern NEXT_ITEM = Pattern.compile("\\R(?=\\s*(?:\\R|$|[-*#|]))");

  /** The endings of the files whose names stand in quotation marks. */
  private static final Set<String> QUOTING = Set.of("json", "xmi", "eventchain");

  /** A text in quotation marks, on one line. */
  private static final Pattern QUOTED = Pattern.compile("\"([^\"\\n]+)\"");

  /** A line in which ids of requirements are expected. */
  private static final Pattern NAMING =
      Pattern.compile(".*\\b(requirements?|satisfies|judges)\\b.*");

  private final Path file;
  private final String text;
  private final TextLines lines;
  private final ProjectFiles project;
  private final ProjectSchemas schemas;

  ProjectText(Path file, SourceText source, ProjectFiles project, ProjectSchemas schemas) {
    this.schemas = schemas;
    this.file = file;
    this.text = source.text();
    this.lines = new TextLines(text);
    this.project = project;
  }

  @Override
  public List<Symbol> symbols() {
    return switch (ending()) {
      case "md" -> requirementSymbols();
      case "json" -> JsonOutline.of(text, lines);
      case "xmi", "eventchain" -> XmlOutline.of(text, lines);
      default -> YamlOutline.of(text, lines);
    };
  }

  private String ending() {
    String name = file.getFileName().toString();
    return name.substring(name.lastIndexOf('.') + 1);
  }

  /** Returns the requirements, scenarios, components and topics that a text declares. */
  @Override
  public List<Symbol> workspaceSymbols() {
    List<Symbol> all = symbols();
    return switch (ending()) {
      case "md" -> all;
      case "json", "xmi", "eventchain" ->
          all.stream()
              .flatMap(each -> Stream.concat(Stream.of(each), each.children().stream()))
              .filter(each -> each.kind() == ElementKind.CLASS)
              .toList();
      default -> all.stream().filter(each -> each.name().equals("name")).map(this::named).toList();
    };
  }

  /** Returns a scenario by its name. */
  private Symbol named(Symbol key) {
    String name = key.detail().isBlank() ? key.name() : key.detail();
    return new Symbol(name, "", ElementKind.MODULE, key.range(), key.nameRange(), List.of());
  }

  private List<Symbol> requirementSymbols() {
    List<Symbol> symbols = new ArrayList<>();
    for (WrittenRequirement each : project.requirements()) {
      project
          .place(each)
          .filter(place -> place.file().equals(file))
          .ifPresent(
              place ->
                  symbols.add(
                      new Symbol(
                          each.id(),
                          each.text(),
                          ElementKind.INVARIANT,
                          new TextRange(place.range().start(), endOfItem(place.range().end())),
                          place.range(),
                          List.of())));
    }
    return symbols;
  }

  /** Returns the end of the lines of a requirement, up to a blank one or one that begins anew. */
  private TextPosition endOfItem(TextPosition id) {
    Matcher after = NEXT_ITEM.matcher(text);
    int end = after.find(lines.offset(id)) ? after.start() : text.length();
    return lines.position(end);
  }

  @Override
  public List<Folding> foldings() {
    return Outline.foldings(symbols());
  }

  /** A name at a position, and the requirement that has it. */
  private record Named(TextRange range, WrittenRequirement requirement) {}

  private Optional<Named> named(TextPosition position) {
    int offset = lines.offset(position);
    Matcher word = ID.matcher(text);
    int line = text.lastIndexOf('\n', Math.max(0, offset - 1)) + 1;
    for (boolean found = word.find(line); found && word.start() <= offset; found = word.find()) {
      if (offset <= word.end()) {
        String id = word.group();
        TextRange range = lines.range(word.start(), word.end());
        return project.requirements().stream()
            .filter(each -> each.id().equals(id))
            .findFirst()
            .map(each -> new Named(range, each));
      }
    }
    return Optional.empty();
  }

  @Override
  public List<Completion> completions(TextPosition position) {
    int offset = lines.offset(position);
    Optional<FormulaNames> formulas = formulas();
    return Stream.<Supplier<List<Completion>>>of(
            () -> formulas.map(each -> each.compared(offset)).orElse(List.of()),
            () -> yaml().map(each -> each.at(offset)).orElse(List.of()),
            () -> formulas.map(each -> each.words(offset)).orElse(List.of()),
            () -> ending().matches("xmi|eventchain") ? List.of() : requirements(offset))
        .map(Supplier::get)
        .filter(found -> !found.isEmpty())
        .findFirst()
        .orElse(List.of());
  }

  private Optional<YamlCompletion> yaml() {
    return project
        .kind(file, text)
        .map(
            kind ->
                new YamlCompletion(kind, schemas.of(kind), new ProjectNames(project, file), text));
  }

  /** Returns what is known of names in formulas. */
  private Optional<FormulaNames> formulas() {
    return project
        .kind(file, text)
        .filter(FORMULAS::contains)
        .map(kind -> new FormulaNames(project, text, kind));
  }

  /** Proposes requirements where the words of a line ask for some. */
  private List<Completion> requirements(int offset) {
    int start = offset;
    while (start > 0 && isPartOfId(text.charAt(start - 1))) {
      start--;
    }
    int line = text.lastIndexOf('\n', Math.max(0, offset - 1)) + 1;
    if (line > offset || !NAMING.matcher(text.substring(line, offset)).matches()) {
      return List.of();
    }
    TextRange replaced = lines.range(start, offset);
    return project.requirements().stream()
        .map(
            each ->
                new Completion(
                    each.id(), ElementKind.INVARIANT, each.text(), "", each.id(), false, replaced))
        .toList();
  }

  private static boolean isPartOfId(char c) {
    return Character.isLetterOrDigit(c) || "_.-".indexOf(c) >= 0;
  }

  @Override
  public Optional<Hover> hover(TextPosition position) {
    return named(position)
        .map(named -> new Hover(description(named.requirement()), named.range()))
        .or(() -> formulas().flatMap(each -> each.described(lines.offset(position))))
        .or(() -> yaml().flatMap(each -> each.described(lines.offset(position))))
        .or(() -> describedName(lines.offset(position)));
  }

  /** Returns the text of a requirement, and the files that name it. */
  private String description(WrittenRequirement requirement) {
    StringBuilder description =
        new StringBuilder("**" + requirement.id() + "** " + requirement.text());
    List<String> files =
        project.uses(requirement.id()).stream()
            .map(FileRange::file)
            .filter(each -> !each.equals(Path.of(requirement.location().file())))
            .map(project::name)
            .distinct()
            .toList();
    description.append(files.isEmpty() ? "\n\nNo other file names it." : "\n\nNamed in:\n");
    files.forEach(each -> description.append("\n- ").append(each));
    return description.toString();
  }

  @Override
  public List<FileRange> definitions(TextPosition position) {
    return named(position)
        .flatMap(named -> project.place(named.requirement()))
        .or(() -> name(position).flatMap(project::declaration))
        .stream()
        .toList();
  }

  /** Returns the name of a component, topic or scenario at a position. */
  private Optional<String> name(TextPosition position) {
    int offset = lines.offset(position);
    return yaml()
        .flatMap(each -> each.name(offset))
        .or(() -> formulas().flatMap(each -> each.topic(offset)))
        .or(() -> quoted(offset).map(each -> each.group(1)).filter(about()::containsKey));
  }

  /** Returns the text in quotation marks around an offset, in JSON and XMI. */
  private Optional<Matcher> quoted(int offset) {
    if (!QUOTING.contains(ending())) {
      return Optional.empty();
    }
    Matcher quoted = QUOTED.matcher(text);
    int line = text.lastIndexOf('\n', Math.max(0, offset - 1)) + 1;
    for (boolean found = quoted.find(line);
        found && quoted.start() <= offset;
        found = quoted.find()) {
      if (offset <= quoted.end()) {
        return Optional.of(quoted);
      }
    }
    return Optional.empty();
  }

  /** Returns the components and topics, with what is known of them. */
  private Map<String, String> about() {
    Map<String, String> all = new TreeMap<>(project.components());
    all.putAll(project.topics());
    return all;
  }

  private Optional<Hover> describedName(int offset) {
    return quoted(offset)
        .flatMap(
            each ->
                Optional.ofNullable(about().get(each.group(1)))
                    .filter(about -> !about.isEmpty())
                    .map(about -> new Hover(about, lines.range(each.start(1), each.end(1)))));
  }

  @Override
  public List<FileRange> references(TextPosition position, boolean declaration) {
    Optional<Named> named = named(position);
    Optional<String> name = named.map(each -> each.requirement().id()).or(() -> name(position));
    Optional<FileRange> declared =
        named.isPresent()
            ? project.place(named.get().requirement())
            : name.flatMap(project::declaration);
    return name.map(project::uses).orElse(List.of()).stream()
        .filter(each -> declaration || !declared.equals(Optional.of(each)))
        .toList();
  }

  @Override
  public RenameTarget renameTarget(TextPosition position) {
    Optional<Named> named = named(position);
    if (named.isEmpty()) {
      return RenameTarget.refused("There is no id of a requirement here.");
    }
    WrittenRequirement requirement = named.get().requirement();
    return project.owns(requirement)
        ? RenameTarget.of(named.get().range(), requirement.id())
        : RenameTarget.refused(
            "The requirement is kept in " + requirement.location().file() + ", by another tool.");
  }

  @Override
  public Rename rename(TextPosition position, String newName) {
    RenameTarget target = renameTarget(position);
    if (!target.isAllowed()) {
      return Rename.refused(target.refusal());
    } else if (!ID.matcher(newName).matches()) {
      return Rename.refused("'" + newName + "' is no id: letters, digits, '.', '-' and '_'.");
    } else if (!project.uses(newName).isEmpty()) {
      return Rename.refused("The project names '" + newName + "' already.");
    }
    return Rename.of(
        project.uses(target.name()).stream()
            .map(each -> new FileEdit(each.file(), each.range(), newName))
            .toList());
  }

  @Override
  public List<SemanticToken> tokens() {
    if (!file.toString().matches(".*\\.ya?ml")) {
      return List.of();
    }
    Set<String> ids =
        project.requirements().stream().map(WrittenRequirement::id).collect(Collectors.toSet());
    return new YamlTokens(project.kind(file, text), ids, FormulaNames.WORDS).of(text);
  }

  @Override
  public Optional<SignatureHelp> signatureHelp(TextPosition position) {
    return Optional.empty();
  }

  @Override
  public List<FileRange> typeDefinitions(TextPosition position) {
    return List.of();
  }

  /** Returns where the requirement is named that is written or named at a position. */
  @Override
  public List<FileRange> implementations(TextPosition position) {
    return references(position, false);
  }

  @Override
  public List<TextRange> selectionRanges(TextPosition position) {
    return Outline.selection(symbols(), position);
  }

  @Override
  public List<InlayHint> inlayHints(TextRange range) {
    return List.of();
  }

  @Override
  public List<Call.Item> callItems(TextPosition position) {
    return List.of();
  }
}
