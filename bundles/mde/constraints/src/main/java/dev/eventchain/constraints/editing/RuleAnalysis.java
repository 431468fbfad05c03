package dev.eventchain.constraints.editing;

import dev.eventchain.constraints.document.MemberContext;
import dev.eventchain.constraints.document.RuleDocument;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.editing.Call;
import dev.eventchain.editing.Completion;
import dev.eventchain.editing.ElementKind;
import dev.eventchain.editing.FileRange;
import dev.eventchain.editing.Folding;
import dev.eventchain.editing.SemanticToken;
import dev.eventchain.editing.Symbol;
import dev.eventchain.editing.TextPosition;
import dev.eventchain.ocl.Scope;
import dev.eventchain.ocl.assist.ExpressionPlace;
import dev.eventchain.ocl.editing.Mention;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EClass;

/** Analysis of one version of a rule document. */
final class RuleAnalysis extends DeclaredText {

  private final RuleText text;
  private final RuleScopes scopes;
  private volatile List<ExpressionPlace> places;
  private volatile List<Mention> outer;

  RuleAnalysis(RuleText text, RuleDeclarations declarations, RuleLanguageService service) {
    super(text.file(), text.source(), text.lines(), declarations, service);
    this.text = text;
    this.scopes = new RuleScopes(text, declarations.world().language());
  }

  /** Returns whether nothing has changed that it depends on. */
  boolean isOf(RuleDeclarations present) {
    return declarations().equals(present);
  }

  @Override
  protected List<ExpressionPlace> places() {
    List<ExpressionPlace> found = places;
    if (found == null) {
      found = new ArrayList<>();
      for (RuleDocument.Clause clause : text.document().clauses()) {
        Scope scope = scopes.of(clause);
        if (!clause.definition()) {
          found.add(place(clause.text(), scope));
        } else if (DefinitionText.of(clause.text()).hasValue()) {
          found.add(place(DefinitionText.of(clause.text()).value(), scope));
        }
        if (clause.message() != null) {
          found.add(place(clause.message(), scope));
        }
      }
      for (MemberContext member : text.document().members()) {
        found.add(place(member.text(), scopes.of(member)));
      }
      found.sort(Comparator.comparingInt(each -> each.range().start()));
      places = List.copyOf(found);
    }
    return found;
  }

  private ExpressionPlace place(SourceRange range, Scope scope) {
    return new ExpressionPlace(range, scope, language().assistant());
  }

  @Override
  protected Optional<ExpressionPlace> placeAt(int offset) {
    int index = text.sectionAt(offset);
    if (index < 0) {
      return Optional.empty();
    }
    int start = text.sections().get(index).start();
    int limit = text.limit(index);
    return places().stream()
        .filter(each -> each.range().start() >= start && each.range().start() <= offset)
        .filter(each -> each.range().end() <= limit)
        .filter(each -> offset <= each.range().end() || isLast(each, limit))
        .reduce((first, second) -> second)
        .map(each -> upTo(each, offset));
  }

  /** Returns whether an expression is the last part of its clause, so that it may go on. */
  private boolean isLast(ExpressionPlace place, int limit) {
    return places().stream()
        .noneMatch(
            each -> each.range().start() > place.range().start() && each.range().end() <= limit);
  }

  private ExpressionPlace upTo(ExpressionPlace place, int offset) {
    return offset <= place.range().end()
        ? place
        : place(text.source().range(place.range().start(), offset), place.scope());
  }

  @Override
  protected List<Mention> outerMentions() {
    List<Mention> found = outer;
    if (found == null) {
      found = new RuleMentions(text, declarations().world(), scopes).all();
      outer = found;
    }
    return found;
  }

  @Override
  public List<FileRange> implementations(TextPosition position) {
    return mentionAt(position).map(this::implementationsOf).orElse(List.of());
  }

  private List<FileRange> implementationsOf(Mention mention) {
    Object target = mention.target();
    if (mention.kind() == Mention.Kind.TYPE && target instanceof EClass type) {
      return declarationsBelow(type);
    } else if (isOwn(target)) {
      return declaration(target).stream().toList();
    }
    return family().stream()
        .filter(RuleAnalysis.class::isInstance)
        .map(RuleAnalysis.class::cast)
        .filter(each -> !each.text.document().members().isEmpty())
        .flatMap(each -> each.bodiesOf(target))
        .toList();
  }

  /** Returns where the document computes a feature or an operation of a metamodel. */
  private Stream<FileRange> bodiesOf(Object target) {
    return outerMentions().stream()
        .filter(each -> target != null && each.target() == target)
        .filter(each -> each.kind() != Mention.Kind.TYPE)
        .map(each -> new FileRange(file(), range(each)));
  }

  @Override
  protected Optional<Call.Item> itemAround(int offset) {
    int index = text.sectionAt(offset);
    if (index < 0 || offset > text.sections().get(index).end()) {
      return Optional.empty();
    }
    Section section = text.sections().get(index);
    return switch (section.keyword()) {
      case "inv", "def", "body", "derive" -> Optional.of(RuleDeclarations.item(text, section));
      default -> Optional.empty();
    };
  }

  @Override
  public List<Symbol> symbols() {
    return RuleOutline.symbols(text);
  }

  @Override
  public List<Folding> foldings() {
    return RuleOutline.foldings(text);
  }

  @Override
  public List<SemanticToken> tokens() {
    return RuleOutline.tokens(text, language().packages());
  }

  @Override
  public List<Completion> completions(TextPosition position) {
    int offset = lines().offset(position);
    Optional<List<Completion>> comment = RuleProposals.inComment(text, offset);
    if (comment.isPresent()) {
      return comment.get();
    }
    RuleProposals outside = new RuleProposals(text, language(), offset);
    if (outside.namesClass()) {
      return outside.all();
    }
    List<Completion> found = new ArrayList<>(super.completions(position));
    if (placeAt(offset).isPresent() && !found.isEmpty() && outside.startsLine()) {
      found.addAll(outside.clauses());
    }
    return found;
  }

  @Override
  protected List<Completion> outerCompletions(int offset) {
    return new RuleProposals(text, language(), offset).all();
  }

  @Override
  protected List<SourceRange> structureAround(int offset) {
    List<SourceRange> ranges = new ArrayList<>();
    int index = text.sectionAt(offset);
    if (index >= 0) {
      Section section = text.sections().get(index);
      ranges.add(text.source().range(section.start(), section.end()));
      int context = index;
      while (context >= 0 && !text.sections().get(context).keyword().equals("context")) {
        context--;
      }
      if (context >= 0) {
        int end = RuleOutline.lastOf(text, context);
        ranges.add(
            text.source()
                .range(text.sections().get(context).start(), text.sections().get(end).end()));
      }
    }
    return ranges;
  }

  /** Returns the kind of a clause in an outline. */
  static ElementKind kindOf(Section section) {
    return switch (section.keyword()) {
      case "package" -> ElementKind.PACKAGE;
      case "context" -> ElementKind.CONTEXT;
      case "def" -> ElementKind.DEFINITION;
      default -> ElementKind.INVARIANT;
    };
  }
}
