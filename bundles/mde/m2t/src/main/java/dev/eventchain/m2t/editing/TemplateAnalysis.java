package dev.eventchain.m2t.editing;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.editing.Call;
import dev.eventchain.editing.Completion;
import dev.eventchain.editing.EcorePlaces;
import dev.eventchain.editing.FileRange;
import dev.eventchain.editing.Folding;
import dev.eventchain.editing.InlayHint;
import dev.eventchain.editing.SemanticToken;
import dev.eventchain.editing.Symbol;
import dev.eventchain.editing.TextPosition;
import dev.eventchain.editing.TextRange;
import dev.eventchain.m2t.syntax.Syntax;
import dev.eventchain.m2t.syntax.TagBlock;
import dev.eventchain.m2t.syntax.TemplateLexer;
import dev.eventchain.m2t.syntax.Token;
import dev.eventchain.m2t.template.CallLibrary;
import dev.eventchain.m2t.template.Template;
import dev.eventchain.ocl.ExpressionLanguage;
import dev.eventchain.ocl.assist.AssistedText;
import dev.eventchain.ocl.assist.ExpressionPlace;
import dev.eventchain.ocl.editing.Mention;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;

/** Analysis of one version of a template file. */
final class TemplateAnalysis extends AssistedText {

  private final TemplateText text;
  private final TemplateWorld world;
  private final Map<String, Path> imports;
  private final EcorePlaces ecore;
  private final TemplateLanguageService service;
  private final List<TemplateUnit> units;
  private final TemplateNames names;

  TemplateAnalysis(
      TemplateText text,
      TemplateWorld world,
      Map<String, Path> imports,
      EcorePlaces ecore,
      TemplateLanguageService service) {
    super(text.file(), text.source(), text.lines());
    this.text = text;
    this.world = world;
    this.imports = imports;
    this.ecore = ecore;
    this.service = service;
    this.units = TemplateUnit.of(text, world.linked());
    this.names = new TemplateNames(world);
  }

  boolean isOf(TemplateWorld present, TemplateText version) {
    return world == present && text.equals(version);
  }

  ExpressionLanguage language() {
    return world.linked().language();
  }

  private Optional<TemplateUnit> unitAt(int offset) {
    return units.stream()
        .filter(each -> each.block().start() <= offset && offset <= each.block().end())
        .findFirst();
  }

  @Override
  protected List<ExpressionPlace> places() {
    return units.stream().flatMap(each -> each.compiled().places().stream()).toList();
  }

  @Override
  protected Optional<ExpressionPlace> placeAt(int offset) {
    Token tag = text.tagAt(offset);
    if (tag == null || tag.kind() == Token.Kind.COMMENT || tag.kind() == Token.Kind.CLOSE) {
      return Optional.empty();
    }
    Optional<TemplateUnit> unit = unitAt(offset);
    Optional<ExpressionPlace> known =
        unit.stream()
            .flatMap(each -> each.compiled().places().stream())
            .filter(each -> each.touches(offset) && each.range().start() > tag.start())
            .min(Comparator.comparingInt(each -> each.range().end() - each.range().start()));
    String word = text.wordOf(tag);
    boolean head = Set.of("template", "query", "module", "import").contains(word);
    return known.isPresent() || head || unit.isEmpty()
        ? known
        : Optional.of(openPlace(tag, word, offset, unit.get()));
  }

  /** Returns what is written in a tag, as an expression. */
  private ExpressionPlace openPlace(Token tag, String word, int offset, TemplateUnit unit) {
    int start = tag.start() + 1;
    boolean keyword = TemplateLexer.keywords().contains(word);
    if (keyword && start + word.length() < offset) {
      start += word.length();
    }
    int end = Math.max(offset, text.contentEnd(tag));
    SourceRange range = text.source().range(Math.min(start, offset), end);
    return new ExpressionPlace(range, unit.scopeAt(tag.start()), language().assistant());
  }

  @Override
  protected List<Mention> outerMentions() {
    return units.stream()
        .flatMap(each -> names.of(each, keyOf(each)).stream())
        .sorted(Comparator.comparingInt(Mention::start))
        .distinct()
        .toList();
  }

  @Override
  protected List<Mention> outerMentionsNear(int offset) {
    return unitAt(offset).map(each -> names.of(each, keyOf(each))).orElse(List.of());
  }

  private CallableKey keyOf(TemplateUnit unit) {
    return new CallableKey(text.file(), unit.isTemplate(), unit.number());
  }

  @Override
  protected List<TemplateAnalysis> family() {
    List<TemplateAnalysis> all = new ArrayList<>(service.all());
    if (all.stream().noneMatch(each -> each.file().equals(file()))) {
      all.add(this);
    }
    return all;
  }

  @Override
  protected List<Object> targets(Mention mention) {
    if (mention.target() instanceof CallLibrary.Call call) {
      return call.candidates().stream()
          .flatMap(each -> world.key(each).stream())
          .map(Object.class::cast)
          .toList();
    } else if (mention.target() instanceof EObject || mention.target() instanceof CallableKey) {
      return List.of(mention.target());
    }
    return List.of();
  }

  /** Returns what is named together: a call may call each of several templates of a name. */
  @Override
  protected Set<Object> together(List<Object> targets, List<? extends AssistedText> texts) {
    Set<Object> all = new LinkedHashSet<>(targets);
    boolean grown = targets.stream().anyMatch(CallableKey.class::isInstance);
    while (grown) {
      grown = false;
      for (AssistedText each : texts) {
        for (Mention mention : each.mentions()) {
          List<Object> others = ((TemplateAnalysis) each).targets(mention);
          grown |= others.stream().anyMatch(all::contains) && all.addAll(others);
        }
      }
    }
    return all;
  }

  @Override
  protected boolean isOwn(Object target) {
    return target instanceof CallableKey;
  }

  @Override
  protected Optional<FileRange> declaration(Object target) {
    if (target instanceof CallableKey key) {
      return unitOf(key)
          .map(
              found -> {
                Syntax.Name name = found.unit().name();
                TextRange range =
                    found.text().lines().range(name.start(), name.start() + name.text().length());
                return new FileRange(key.file(), range);
              });
    }
    return target instanceof EObject element ? ecore.of(element) : Optional.empty();
  }

  private record Found(TemplateText text, TemplateUnit unit) {}

  private Optional<Found> unitOf(CallableKey key) {
    return service
        .find(key.file())
        .flatMap(
            analysis ->
                analysis.units.stream()
                    .filter(each -> analysis.keyOf(each).equals(key))
                    .findFirst()
                    .map(each -> new Found(analysis.text, each)));
  }

  @Override
  protected String collision(Object target, String newName) {
    boolean taken =
        family().stream().anyMatch(each -> each.world.linked().callable().contains(newName));
    if (taken) {
      return "There is already a template or a query '" + newName + "'.";
    }
    boolean member =
        unitOf((CallableKey) target)
            .flatMap(found -> found.unit().callable())
            .filter(each -> !each.parameters().isEmpty())
            .map(each -> each.parameters().get(0).type())
            .filter(type -> language().assistant().hasMember(type, newName))
            .isPresent();
    return member ? "It would hide the operation or feature '" + newName + "'." : "";
  }

  @Override
  protected String describe(Mention mention) {
    List<String> lines = new ArrayList<>();
    StringBuilder documentation = new StringBuilder();
    for (Object target : targets(mention)) {
      if (target instanceof CallableKey key) {
        unitOf(key)
            .ifPresent(
                found -> {
                  lines.add(TemplateOutline.headOf(found.unit()));
                  String text = TemplateOutline.documentation(found.text(), found.unit());
                  if (!text.isEmpty()) {
                    documentation.append("\n\n").append(text);
                  }
                });
      }
    }
    return lines.isEmpty()
        ? super.describe(mention)
        : "```mtl\n" + String.join("\n", lines) + "\n```" + documentation;
  }

  @Override
  public List<FileRange> definitions(TextPosition position) {
    int offset = lines().offset(position);
    Token tag = text.tagAt(offset);
    if (tag != null && tag.kind() == Token.Kind.DECLARATION) {
      for (Syntax.Name name : TemplateOutline.modules(text)) {
        if (name.start() <= offset && offset <= name.start() + name.text().length()) {
          Path other = imports.get(name.text());
          return other == null
              ? List.of()
              : List.of(new FileRange(other, TextRange.at(new TextPosition(0, 0))));
        }
      }
    }
    return super.definitions(position);
  }

  @Override
  public List<FileRange> implementations(TextPosition position) {
    Optional<Mention> mention = mentionAt(position);
    if (mention.isEmpty()) {
      return List.of();
    } else if (mention.get().target() instanceof EClass type) {
      return language().packages().classesBelow(type).stream()
          .flatMap(each -> declaration(each).stream())
          .toList();
    }
    List<Object> wanted = targets(mention.get());
    List<FileRange> found = new ArrayList<>();
    for (TemplateAnalysis each : family()) {
      for (TemplateUnit unit : each.units) {
        boolean overrides =
            unit.callable().stream()
                .filter(Template.class::isInstance)
                .flatMap(template -> ((Template) template).overridden().stream())
                .anyMatch(other -> each.world.key(other).filter(wanted::contains).isPresent());
        if (overrides) {
          declaration(each.keyOf(unit)).ifPresent(found::add);
        }
      }
    }
    return found;
  }

  @Override
  protected Optional<Call.Item> itemAround(int offset) {
    return unitAt(offset).map(each -> TemplateOutline.item(text, each));
  }

  @Override
  protected Optional<Call.Item> itemOf(Object target) {
    return target instanceof CallableKey key
        ? unitOf(key).map(found -> TemplateOutline.item(found.text(), found.unit()))
        : Optional.empty();
  }

  @Override
  public List<Symbol> symbols() {
    return TemplateOutline.symbols(text, units);
  }

  @Override
  public List<Folding> foldings() {
    return TemplateOutline.foldings(text);
  }

  @Override
  public List<SemanticToken> tokens() {
    return TemplateColours.of(text, units, language().packages());
  }

  @Override
  public List<Completion> completions(TextPosition position) {
    int offset = lines().offset(position);
    TemplateProposals proposals = new TemplateProposals(text, language(), service, offset);
    List<Completion> found = new ArrayList<>(proposals.before());
    if (!proposals.isAlone()) {
      found.addAll(super.completions(position));
    }
    return found;
  }

  @Override
  protected List<Completion> outerCompletions(int offset) {
    return new TemplateProposals(text, language(), service, offset).outside();
  }

  @Override
  protected List<SourceRange> structureAround(int offset) {
    List<SourceRange> ranges = new ArrayList<>();
    Token tag = text.tagAt(offset);
    if (tag != null) {
      ranges.add(text.source().range(tag.start(), tag.end()));
    }
    addBlocks(text.blocks(), offset, ranges);
    return ranges;
  }

  private void addBlocks(List<TagBlock> blocks, int offset, List<SourceRange> into) {
    for (TagBlock each : blocks) {
      if (each.start() <= offset && offset <= each.end()) {
        into.add(text.source().range(each.start(), each.end()));
        if (each.isAround(offset)) {
          into.add(text.source().range(each.open().end(), each.close().start()));
        }
        addBlocks(each.children(), offset, into);
      }
    }
  }

  @Override
  protected List<InlayHint> outerHints(int start, int end) {
    return units.stream()
        .filter(each -> each.block().end() >= start && each.block().start() <= end)
        .flatMap(each -> each.compiled().untyped().stream())
        .filter(each -> each.end() >= start && each.end() <= end)
        .map(each -> hint(each.end(), each.type()))
        .toList();
  }
}
