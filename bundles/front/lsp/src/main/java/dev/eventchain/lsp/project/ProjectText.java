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
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A text of a project: its outline by keys or requirements, and what is known of the requirements
 * that it names.
 */
final class ProjectText implements Analysis {

  private static final Pattern ID = Pattern.compile("[A-Za-z0-9][\\w.-]*");

  /** A key of YAML, or an item of a list that has one. */
  private static final Pattern KEY =
      Pattern.compile("^((?:- )?)([A-Za-z_][\\w.-]*):", Pattern.MULTILINE);

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
    return file.toString().endsWith(".md") ? requirementSymbols() : keySymbols();
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
                          place.range(),
                          place.range(),
                          List.of())));
    }
    return symbols;
  }

  /** Returns the keys at the left margin, each with the text up to the next one. */
  private List<Symbol> keySymbols() {
    List<int[]> keys = new ArrayList<>();
    Matcher matcher = KEY.matcher(text);
    while (matcher.find()) {
      keys.add(new int[] {matcher.start(2), matcher.end(2)});
    }
    List<Symbol> symbols = new ArrayList<>();
    for (int i = 0; i < keys.size(); i++) {
      int end = i + 1 < keys.size() ? lastOf(keys.get(i + 1)[0]) : text.length();
      TextRange name = lines.range(keys.get(i)[0], keys.get(i)[1]);
      TextRange whole = lines.range(keys.get(i)[0], Math.max(keys.get(i)[1], end));
      String key = text.substring(keys.get(i)[0], keys.get(i)[1]);
      symbols.add(new Symbol(key, "", ElementKind.ATTRIBUTE, whole, name, List.of()));
    }
    return symbols;
  }

  /** Returns the end of the line before the one at an offset. */
  private int lastOf(int next) {
    return Math.max(0, text.lastIndexOf('\n', Math.max(0, next - 1)));
  }

  @Override
  public List<Folding> foldings() {
    return keySymbols().stream()
        .map(Symbol::range)
        .filter(range -> range.end().line() > range.start().line())
        .map(range -> new Folding(range.start().line(), range.end().line(), Folding.Kind.BLOCK))
        .toList();
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
    List<Completion> names = formulas().map(each -> each.at(offset)).orElse(List.of());
    if (!names.isEmpty()) {
      return names;
    }
    List<Completion> found = yaml().map(each -> each.at(offset)).orElse(List.of());
    return found.isEmpty() ? requirements(offset) : found;
  }

  private Optional<YamlCompletion> yaml() {
    return project
        .kind(file, text)
        .map(
            kind ->
                new YamlCompletion(kind, schemas.of(kind), new ProjectNames(project, file), text));
  }

  /** Returns what is known of names in formulas, which scenarios and campaigns have. */
  private Optional<FormulaNames> formulas() {
    return project
        .kind(file, text)
        .filter(
            kind -> kind == ProjectSchemas.Kind.SCENARIO || kind == ProjectSchemas.Kind.CAMPAIGN)
        .map(kind -> new FormulaNames(project, text));
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
        .or(() -> yaml().flatMap(each -> each.described(lines.offset(position))));
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
    return yaml().flatMap(each -> each.name(lines.offset(position)));
  }

  @Override
  public List<FileRange> references(TextPosition position, boolean declaration) {
    Optional<Named> named = named(position);
    Optional<FileRange> declared = named.flatMap(each -> project.place(each.requirement()));
    return named.map(each -> project.uses(each.requirement().id())).orElse(List.of()).stream()
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
    return List.of();
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
    return List.of();
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
