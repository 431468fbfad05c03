package dev.eventchain.project.requirements;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Reads the headings, tables, directives, lists and paragraphs of reStructuredText. */
final class RstBlocks extends TextBlocks {

  private static final Pattern LINE = Pattern.compile("([=~^\"'`#*+.:_<>-])\\1{2,}\\s*");
  private static final Pattern DIRECTIVE =
      Pattern.compile("\\s*\\.\\. ([A-Za-z][A-Za-z0-9:_+.-]*)::(?:\\s+(.*))?");
  private static final Pattern COMMENT = Pattern.compile("\\s*\\.\\.(\\s.*)?");
  private static final Pattern OPTION = Pattern.compile("\\s+:([A-Za-z0-9_ -]+):\\s*(.*)");
  private static final Pattern NAMED = Pattern.compile("\\s*[A-Za-z][A-Za-z0-9._/-]*[0-9]\\s*");
  private static final Pattern CLASSIFIED = Pattern.compile("\\s+:\\s.*");

  /** Directives whose content is no text. */
  private static final Set<String> CODE =
      Set.of(
          "code",
          "code-block",
          "sourcecode",
          "literalinclude",
          "math",
          "raw",
          "parsed-literal",
          "image",
          "uml",
          "graphviz",
          "mermaid");

  /** Option of sphinx-needs for the need in which another one is. */
  static final String AROUND = "parent_needs";

  /** Level of a term of a list of definitions, which is below that of any heading. */
  static final int TERM = 1_000;

  /** Greatest number of directives in each other. */
  private static final int DEEPEST = 20;

  private final RstFiles.Open file;
  private final SourceText source;
  private final RstFiles files;
  private final Reading reading;
  private final int depth;
  private final List<String> levels;

  RstBlocks(List<String> lines, RstFiles.Open file, RstFiles files, Reading reading) {
    super(lines, 0);
    this.depth = 0;
    this.levels = new ArrayList<>();
    this.file = file;
    this.source = file.source();
    this.files = files;
    this.reading = reading;
  }

  /** Creates a reader of what is inside of another text, or of a file that it takes in. */
  private RstBlocks(
      List<String> lines, int before, RstFiles.Open file, List<String> levels, RstBlocks around) {
    super(lines, before);
    this.depth = around.depth + 1;
    this.levels = levels;
    this.file = file;
    this.source = file.source();
    this.files = around.files;
    this.reading = around.reading;
  }

  @Override
  boolean isSpecial(int index) {
    String line = lines.get(index);
    return COMMENT.matcher(line).matches()
        || RstTables.isBorder(line)
        || isHeading(index)
        || (LINE.matcher(line).matches() && isHeading(index + 1))
        || isTerm(index)
        || title(index).isPresent();
  }

  private boolean isHeading(int index) {
    return index + 1 < lines.size()
        && !lines.get(index).isBlank()
        && !LINE.matcher(lines.get(index)).matches()
        && LINE.matcher(lines.get(index + 1)).matches();
  }

  /** Returns whether a line is an id alone, above its text. */
  private boolean isTerm(int index) {
    return NAMED.matcher(lines.get(index)).matches()
        && index + 1 < lines.size()
        && !lines.get(index + 1).isBlank()
        && indent(lines.get(index + 1)) > indent(lines.get(index));
  }

  /**
   * Returns the id and the title of a term of a list of definitions, {@code REQ-1 Title} or {@code
   * REQ-1 : kind} above what is indented.
   */
  private Optional<TextIds.Named> title(int index) {
    String line = lines.get(index);
    boolean isTerm =
        index + 1 < lines.size()
            && !line.isBlank()
            && !isEntry(index)
            && !lines.get(index + 1).isBlank()
            && !isEntry(index + 1)
            && indent(lines.get(index + 1)) > indent(line)
            && (index == 0
                || lines.get(index - 1).isBlank()
                || indent(lines.get(index - 1)) > indent(line));
    return (isTerm ? TextIds.ofHeading(line.strip()) : Optional.<TextIds.Named>empty())
        .filter(it -> !it.text().isBlank() && !TextIds.isAnother(it))
        .filter(
            it ->
                TextIds.ofLine(line.strip()).isEmpty() || CLASSIFIED.matcher(it.text()).matches());
  }

  @Override
  void special() {
    String line = lines.get(next);
    Matcher directive = DIRECTIVE.matcher(line);
    if (directive.matches()) {
      directive(directive);
    } else if (COMMENT.matcher(line).matches()) {
      int indent = indent(line);
      next++;
      skipBelow(indent);
    } else if (RstTables.isBorder(line)) {
      RstTables.read(this, source, reading);
    } else if (isTerm(next)) {
      lines.set(next, line.stripTrailing() + ":");
    } else if (title(next).isPresent()) {
      definition(title(next).get());
    } else {
      heading();
    }
  }

  /** Skips the literal block below a paragraph that ends with two colons. */
  @Override
  void end(int indent, String last) {
    if (last.endsWith("::")) {
      skipBelow(indent);
    }
  }

  private void heading() {
    String style = "";
    if (LINE.matcher(lines.get(next)).matches()) {
      style = "over";
      next++;
    }
    style += lines.get(next + 1).charAt(0);
    if (!levels.contains(style)) {
      levels.add(style);
    }
    int level = levels.indexOf(style) + 1;
    blocks.add(new TextBlock.Heading(number(next), level, lines.get(next).strip()));
    next += 2;
  }

  /**
   * Reads a term with its definition like a heading with its text, which ends with it; a title that
   * requires something begins the text.
   */
  private void definition(TextIds.Named term) {
    if (TextKinds.isRequirement(term.text())) {
      String indent = " ".repeat(indent(lines.get(next)));
      lines.set(
          next, indent + term.id() + ": " + term.text().replaceFirst("^\\s*:\\s", "").strip());
      return;
    }
    int level = TERM + indent(lines.get(next));
    blocks.add(new TextBlock.Heading(number(next), level, lines.get(next).strip()));
    int indent = indent(lines.get(next));
    int first = ++next;
    skipBelow(indent);
    inner(new ArrayList<>(lines.subList(first, next)), before + first);
    blocks.add(new TextBlock.Heading(number(next - 1), level, ""));
  }

  private void skipBelow(int indent) {
    while (next < lines.size() && (lines.get(next).isBlank() || indent(lines.get(next)) > indent)) {
      next++;
    }
  }

  private void directive(Matcher directive) {
    int first = next;
    int indent = indent(lines.get(first));
    next++;
    Map<String, String> options = new LinkedHashMap<>();
    for (Matcher option = option(); option != null; option = option()) {
      options.put(option.group(1).strip(), option.group(2).strip());
      next++;
    }
    int body = next;
    skipBelow(indent);
    List<String> content = new ArrayList<>(lines.subList(body, next));
    String title = directive.group(2) == null ? "" : directive.group(2).strip();
    read(directive.group(1), title, options, content, first);
  }

  private void read(
      String name, String title, Map<String, String> options, List<String> content, int first) {
    int above = before + next - content.size();
    RstTables tables = new RstTables(number(first), options, content, above);
    if (name.equals("include")) {
      include(title, options, first);
    } else if (name.equals("toctree")) {
      documents(content, above);
    } else if (name.equals("list-table")) {
      tables.ofLists(source, reading).ifPresent(blocks::add);
    } else if (name.equals("csv-table")) {
      tables.ofCsv(source, reading).ifPresent(blocks::add);
    } else if (options.containsKey(idOption())) {
      need(new TextBlock.Directive(number(first), name, title, options, ""), content, above);
    } else if (!CODE.contains(name)) {
      inner(content, above);
    }
  }

  /** Adds a directive with an id, and those in it, whose texts are not a part of its own. */
  private void need(TextBlock.Directive need, List<String> content, int above) {
    List<String> text = new ArrayList<>();
    List<TextBlock> nested = new ArrayList<>();
    RstBlocks inside = inside(content, above);
    while (inside.next < content.size()) {
      int at = inside.next;
      String line = content.get(at);
      Matcher directive = DIRECTIVE.matcher(line);
      boolean isDirective = directive.matches();
      if (isDirective && inside.isNeed(at + 1)) {
        inside.directive(directive);
      } else {
        inside.next++;
        if (isDirective ? CODE.contains(directive.group(1)) : COMMENT.matcher(line).matches()) {
          inside.skipBelow(indent(line));
        }
        text.addAll(content.subList(at, inside.next));
      }
    }
    for (TextBlock block : inside.blocks) {
      if (block instanceof TextBlock.Directive inner) {
        inner.options().putIfAbsent(AROUND, need.options().get(idOption()));
      }
      nested.add(block);
    }
    blocks.add(
        new TextBlock.Directive(
            need.line(), need.name(), need.title(), need.options(), String.join(" ", text)));
    blocks.addAll(nested);
  }

  /** Returns whether options that begin in a line have an id. */
  private boolean isNeed(int index) {
    for (int i = index; i < lines.size() && OPTION.matcher(lines.get(i)).matches(); i++) {
      Matcher option = OPTION.matcher(lines.get(i));
      if (option.matches() && option.group(1).strip().equals(idOption())) {
        return true;
      }
    }
    return false;
  }

  /** Reads a file in the place of a directive, with its indent, unless it is code. */
  private void include(String name, Map<String, String> options, int at) {
    boolean isCode = options.containsKey("literal") || options.containsKey("code");
    if (isCode || name.matches("<.*>")) {
      return;
    }
    SourceLocation place = source.at(number(at), 1);
    Optional<RstFiles.Open> named = files.include(file, name, place);
    Optional<RstFiles.Part> part = named.flatMap(it -> files.part(it, options, place));
    if (part.isPresent()) {
      String indent = " ".repeat(indent(lines.get(at)));
      List<String> text = new ArrayList<>();
      part.get().lines().forEach(line -> text.add(line.isBlank() ? line : indent + line));
      SourceText of = named.get().source();
      boolean isMarkdown =
          options.containsKey("parser") && SourceFiles.has(named.get().file(), ".md");
      TextBlocks inside =
          isMarkdown
              ? new MarkdownBlocks(text, part.get().before())
              : new RstBlocks(text, part.get().before(), named.get(), levels, this);
      blocks.add(new TextBlock.Included(number(at), of, inside.read()));
    }
  }

  private void documents(List<String> content, int above) {
    for (int i = 0; i < content.size(); i++) {
      SourceLocation place = source.at(above + i + 1, 1);
      RstReferences.document(content.get(i)).ifPresent(it -> files.document(file, it, place));
    }
  }

  private void inner(List<String> content, int above) {
    blocks.addAll(inside(content, above).read());
  }

  private RstBlocks inside(List<String> content, int above) {
    if (depth >= DEEPEST) {
      String message =
          String.format(Locale.ROOT, "More than %d directives are in each other.", DEEPEST);
      throw Reading.refused(message, source.at(above, 1), "Take some of them out.");
    }
    return new RstBlocks(content, above, file, new ArrayList<>(), this);
  }

  private String idOption() {
    return reading.fields.id().orElse("id");
  }

  private Matcher option() {
    if (next < lines.size()) {
      Matcher option = OPTION.matcher(lines.get(next));
      return option.matches() ? option : null;
    }
    return null;
  }
}
