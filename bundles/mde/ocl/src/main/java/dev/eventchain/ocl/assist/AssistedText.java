package dev.eventchain.ocl.assist;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.editing.Analysis;
import dev.eventchain.editing.Call;
import dev.eventchain.editing.Completion;
import dev.eventchain.editing.FileRange;
import dev.eventchain.editing.Hover;
import dev.eventchain.editing.InlayHint;
import dev.eventchain.editing.Rename;
import dev.eventchain.editing.RenameTarget;
import dev.eventchain.editing.SignatureHelp;
import dev.eventchain.editing.TextLines;
import dev.eventchain.editing.TextPosition;
import dev.eventchain.editing.TextRange;
import dev.eventchain.ocl.editing.Descriptions;
import dev.eventchain.ocl.editing.Members;
import dev.eventchain.ocl.editing.Mention;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.ocl.types.CollectionType;

/**
 * The part of an analysis that is about expressions and names. A language adds what surrounds its
 * expressions, and what else has a name.
 */
public abstract class AssistedText implements Analysis {

  private final Path file;
  private final SourceText source;
  private final TextLines lines;

  /** All names; found when first needed. */
  private volatile List<Mention> all;

  /** The analysis of a text. */
  protected AssistedText(Path file, SourceText source, TextLines lines) {
    this.file = file;
    this.source = source;
    this.lines = lines;
  }

  /** Returns the file. */
  public final Path file() {
    return file;
  }

  /** Returns the text. */
  public final SourceText source() {
    return source;
  }

  /** Returns the lines of the text. */
  public final TextLines lines() {
    return lines;
  }

  /** Returns the expressions of the text, in its order. */
  protected abstract List<ExpressionPlace> places();

  /** Returns the expression at an offset, as far as it is written. */
  protected abstract Optional<ExpressionPlace> placeAt(int offset);

  /** Returns the names outside expressions, in the order of the text. */
  protected abstract List<Mention> outerMentions();

  /** Returns the names outside expressions near an offset; those elsewhere may be left out. */
  protected List<Mention> outerMentionsNear(int offset) {
    return outerMentions();
  }

  /** Returns the texts that share names with this one. */
  protected abstract List<? extends AssistedText> family();

  /** Returns what a name that is no variable stands for: each may be declared somewhere. */
  protected List<Object> targets(Mention mention) {
    return mention.target() == null ? List.of() : List.of(mention.target());
  }

  /**
   * Returns the declarations that must keep a common name with some targets, such as overridden
   * ones, and are therefore renamed together.
   *
   * @param texts the family
   */
  protected Set<Object> together(List<Object> targets, List<? extends AssistedText> texts) {
    return new LinkedHashSet<>(targets);
  }

  /** Returns where something is declared that is no variable. */
  protected abstract Optional<FileRange> declaration(Object target);

  /** Returns whether something is declared in a text of the language, so that it can be renamed. */
  protected abstract boolean isOwn(Object target);

  /** Returns why something that is no variable cannot get a name; empty if it can. */
  protected abstract String collision(Object target, String newName);

  /** Returns the proposals outside expressions. */
  protected abstract List<Completion> outerCompletions(int offset);

  /** Returns the ranges of the text's structure around an offset. */
  protected abstract List<SourceRange> structureAround(int offset);

  /** Returns the hints besides those about variables inside expressions. */
  protected abstract List<InlayHint> outerHints(int start, int end);

  /** Returns what is declared around an offset and can call something. */
  protected abstract Optional<Call.Item> itemAround(int offset);

  /** Returns the item of something that is declared in a text of the language. */
  protected abstract Optional<Call.Item> itemOf(Object target);

  @Override
  public List<Call.Item> callItems(TextPosition position) {
    List<Call.Item> named =
        mentionAt(position).map(this::targets).orElse(List.of()).stream()
            .flatMap(each -> itemOf(each).stream())
            .toList();
    return named.isEmpty()
        ? itemAround(lines.offset(position)).map(List::of).orElse(List.of())
        : named;
  }

  /** Returns the text about a name, in Markdown. */
  protected String describe(Mention mention) {
    return Descriptions.of(mention);
  }

  /** Returns all names, in the order of the text. */
  public final List<Mention> mentions() {
    List<Mention> found = all;
    if (found == null) {
      found =
          Stream.concat(
                  outerMentions().stream(), places().stream().flatMap(e -> e.mentions().stream()))
              .sorted(Comparator.comparingInt(Mention::start))
              .toList();
      all = found;
    }
    return found;
  }

  /** Returns the name at a position. */
  protected final Optional<Mention> mentionAt(TextPosition position) {
    int offset = lines.offset(position);
    return outerMentionsNear(offset).stream()
        .filter(each -> each.touches(offset))
        .findFirst()
        .or(
            () ->
                placeAt(offset)
                    .flatMap(
                        place -> place.assistant().mention(place.range(), place.scope(), offset)));
  }

  @Override
  public List<Completion> completions(TextPosition position) {
    int offset = lines.offset(position);
    return placeAt(offset)
        .map(each -> each.assistant().completions(each.range(), each.scope(), offset, lines))
        .orElseGet(() -> outerCompletions(offset));
  }

  @Override
  public Optional<SignatureHelp> signatureHelp(TextPosition position) {
    int offset = lines.offset(position);
    return placeAt(offset)
        .flatMap(each -> each.assistant().signatureHelp(each.range(), each.scope(), offset));
  }

  @Override
  public Optional<Hover> hover(TextPosition position) {
    return mentionAt(position).map(each -> new Hover(describe(each), range(each)));
  }

  /** Returns the range of a name. */
  protected final TextRange range(Mention mention) {
    return lines.range(mention.start(), mention.end());
  }

  private static boolean isVariable(Mention mention) {
    return mention.kind() == Mention.Kind.VARIABLE || mention.kind() == Mention.Kind.DECLARATION;
  }

  @Override
  public List<FileRange> definitions(TextPosition position) {
    return mentionAt(position).map(this::declarationsOf).orElse(List.of());
  }

  private List<FileRange> declarationsOf(Mention mention) {
    if (isVariable(mention)) {
      int start = mention.declaredAt();
      return start < 0
          ? List.of()
          : List.of(new FileRange(file, lines.range(start, start + mention.name().length())));
    }
    return targets(mention).stream().flatMap(each -> declaration(each).stream()).toList();
  }

  @Override
  public List<FileRange> typeDefinitions(TextPosition position) {
    return mentionAt(position)
        .map(each -> single(each.type()))
        .flatMap(type -> type == null ? Optional.empty() : declaration(type))
        .map(List::of)
        .orElse(List.of());
  }

  private static EClassifier single(EClassifier type) {
    EClassifier element = type;
    while (element instanceof CollectionType<?, ?> collection) {
      element = (EClassifier) collection.getElementType();
    }
    return element;
  }

  @Override
  public List<FileRange> references(TextPosition position, boolean declaration) {
    return mentionAt(position).map(each -> uses(each, declaration)).orElse(List.of());
  }

  private List<FileRange> uses(Mention mention, boolean declaration) {
    if (isVariable(mention)) {
      return mention.declaredAt() < 0 ? List.of() : usesOfVariable(mention, declaration);
    }
    List<? extends AssistedText> texts = family();
    Set<Object> wanted = together(targets(mention), texts);
    List<FileRange> declared = wanted.stream().flatMap(each -> declaration(each).stream()).toList();
    List<FileRange> found = new ArrayList<>();
    if (declaration) {
      found.addAll(declared);
    }
    for (AssistedText text : texts) {
      for (Mention each : text.mentions()) {
        FileRange place = new FileRange(text.file(), text.range(each));
        boolean same = text.targets(each).stream().anyMatch(wanted::contains);
        if (same && !isVariable(each) && !declared.contains(place)) {
          found.add(place);
        }
      }
    }
    return found.stream().distinct().toList();
  }

  private List<FileRange> usesOfVariable(Mention variable, boolean declaration) {
    List<FileRange> found = new ArrayList<>();
    for (Mention each : mentions()) {
      boolean same = isVariable(each) && each.declaredAt() == variable.declaredAt();
      if (same && (declaration || each.start() != each.declaredAt())) {
        found.add(new FileRange(file, range(each)));
      }
    }
    return found.stream().distinct().toList();
  }

  @Override
  public RenameTarget renameTarget(TextPosition position) {
    Optional<Mention> mention = mentionAt(position);
    if (mention.isEmpty()) {
      return RenameTarget.refused("There is no name here that can be changed.");
    }
    String refusal = refusal(mention.get());
    return refusal.isEmpty()
        ? RenameTarget.of(range(mention.get()), mention.get().name())
        : RenameTarget.refused(refusal);
  }

  private String refusal(Mention mention) {
    String name = "'" + mention.name() + "'";
    if (isVariable(mention)) {
      return mention.declaredAt() < 0 ? name + " is declared by the language itself." : "";
    }
    List<Object> targets = targets(mention);
    if (targets.isEmpty()) {
      return name + " is an operation of the library.";
    }
    return targets.stream().allMatch(this::isOwn)
        ? ""
        : name + " is not declared in a file of this language, so it cannot be renamed here.";
  }

  @Override
  public Rename rename(TextPosition position, String newName) {
    RenameTarget target = renameTarget(position);
    if (!target.isAllowed()) {
      return Rename.refused(target.refusal());
    } else if (!Renaming.isName(newName)) {
      return Rename.refused("'" + newName + "' cannot be a name.");
    }
    Mention mention = mentionAt(position).orElseThrow();
    String reason =
        isVariable(mention)
            ? Renaming.collision(mention, newName, places(), outerMentions())
            : collision(mention, newName);
    return reason.isEmpty()
        ? Rename.of(Renaming.edits(uses(mention, true), newName))
        : Rename.refused(reason);
  }

  private String collision(Mention mention, String newName) {
    List<? extends AssistedText> texts = family();
    Set<Object> targets = together(targets(mention), texts);
    return targets.stream()
        .map(each -> collision(each, newName))
        .filter(each -> !each.isEmpty())
        .findFirst()
        .orElseGet(() -> Renaming.capture(targets, newName, texts));
  }

  @Override
  public List<TextRange> selectionRanges(TextPosition position) {
    int offset = lines.offset(position);
    List<SourceRange> ranges = new ArrayList<>();
    mentionAt(position).ifPresent(each -> ranges.add(source.range(each.start(), each.end())));
    placeAt(offset)
        .ifPresent(
            each -> {
              ranges.addAll(each.assistant().partsAround(each.range(), each.scope(), offset));
              ranges.add(each.range().strip());
            });
    ranges.addAll(structureAround(offset));
    ranges.add(source.whole());
    List<TextRange> nested = new ArrayList<>();
    SourceRange inner = source.range(offset, offset);
    ranges.sort(Comparator.comparingInt(each -> each.end() - each.start()));
    for (SourceRange each : ranges) {
      boolean wider = each.start() <= inner.start() && inner.end() <= each.end();
      if (wider && each.end() - each.start() > inner.end() - inner.start()) {
        nested.add(lines.range(each.start(), each.end()));
        inner = each;
      }
    }
    return nested;
  }

  @Override
  public List<InlayHint> inlayHints(TextRange range) {
    int start = lines.offset(range.start());
    int end = lines.offset(range.end());
    List<InlayHint> hints = new ArrayList<>(outerHints(start, end));
    for (ExpressionPlace place : places()) {
      if (place.range().end() >= start && place.range().start() <= end) {
        place.assistant().untypedVariables(place.range(), place.scope()).stream()
            .filter(each -> each.start() >= start && each.end() <= end)
            .forEach(each -> hints.add(hint(each.end(), each.type())));
      }
    }
    hints.sort(Comparator.comparing(InlayHint::position));
    return hints;
  }

  /** Returns the hint with a variable's type after its name. */
  protected final InlayHint hint(int offset, EClassifier type) {
    return new InlayHint(lines.position(offset), " : " + Members.name(type));
  }
}
