package dev.eventchain.constraints.editing;

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
import dev.eventchain.ocl.assist.ExpressionTokens;
import dev.eventchain.ocl.editing.Mention;
import dev.eventchain.ocl.metamodel.PackageIndex;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.ENamedElement;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EParameter;
import org.eclipse.emf.ecore.ETypedElement;

/** Analysis of one version of an {@code .ecore} file: its names and its OCL. */
final class MetamodelAnalysis extends DeclaredText {

  private final MetamodelText text;

  MetamodelAnalysis(
      MetamodelText text, RuleDeclarations declarations, RuleLanguageService service) {
    super(text.file(), text.source(), text.lines(), declarations, service);
    this.text = text;
  }

  /** Returns whether nothing has changed that it depends on. */
  boolean isOf(MetamodelText version, RuleDeclarations present) {
    return text.equals(version) && declarations().equals(present);
  }

  @Override
  protected List<ExpressionPlace> places() {
    return text.expressions().stream()
        .map(
            each ->
                new ExpressionPlace(
                    text.source().range(each.start(), each.end()),
                    scope(each),
                    language().assistant()))
        .toList();
  }

  private Scope scope(MetamodelText.Embedded expression) {
    Optional<ENamedElement> owner = element(expression.owner());
    Optional<EClassifier> type =
        owner
            .map(each -> each instanceof EClassifier ? each : each.eContainer())
            .filter(EClassifier.class::isInstance)
            .map(EClassifier.class::cast);
    if (type.isEmpty()) {
      return language().root();
    }
    Scope scope = language().root().in(type.get().getEPackage()).with("self", type.get());
    if (owner.get() instanceof EOperation operation) {
      for (EParameter each : operation.getEParameters()) {
        scope = scope.with(each.getName(), language().assistant().typeOf(each));
      }
    }
    return scope;
  }

  /** Returns the element of a path in the metamodels; empty if they do not have it, or not yet. */
  private Optional<ENamedElement> element(List<String> path) {
    for (EPackage each : language().packages().all()) {
      List<String> outer = List.of(PackageIndex.qualifiedName(each).split("::", -1));
      int size = outer.size();
      if (path.size() >= size && path.subList(0, size).equals(outer)) {
        Optional<ENamedElement> found = inside(each, path.subList(size, path.size()));
        if (found.isPresent()) {
          return found;
        }
      }
    }
    return Optional.empty();
  }

  private static Optional<ENamedElement> inside(ENamedElement owner, List<String> path) {
    if (path.isEmpty()) {
      return Optional.of(owner);
    }
    return owner.eContents().stream()
        .filter(ENamedElement.class::isInstance)
        .map(ENamedElement.class::cast)
        .filter(each -> !(each instanceof EPackage) && path.get(0).equals(each.getName()))
        .flatMap(each -> inside(each, path.subList(1, path.size())).stream())
        .findFirst();
  }

  @Override
  protected Optional<ExpressionPlace> placeAt(int offset) {
    return places().stream().filter(each -> each.touches(offset)).findFirst();
  }

  @Override
  protected List<Mention> outerMentions() {
    return text.elements().stream().flatMap(each -> mention(each).stream()).toList();
  }

  private Optional<Mention> mention(MetamodelText.Named named) {
    return element(named.path())
        .filter(each -> each instanceof ETypedElement || each instanceof EClassifier)
        .filter(each -> !(each instanceof EParameter))
        .map(
            each -> {
              boolean type = each instanceof EClassifier;
              Mention.Kind kind =
                  type
                      ? Mention.Kind.TYPE
                      : each instanceof EOperation ? Mention.Kind.OPERATION : Mention.Kind.FEATURE;
              EClassifier value =
                  type ? (EClassifier) each : language().assistant().typeOf((ETypedElement) each);
              return new Mention(
                  named.start(),
                  named.end(),
                  kind,
                  named.name(),
                  each,
                  value,
                  null,
                  Mention.ELSEWHERE);
            });
  }

  @Override
  protected List<Completion> outerCompletions(int offset) {
    return List.of();
  }

  @Override
  protected List<SourceRange> structureAround(int offset) {
    return List.of();
  }

  @Override
  protected Optional<Call.Item> itemAround(int offset) {
    return text.expressions().stream()
        .filter(each -> each.start() <= offset && offset <= each.end())
        .findFirst()
        .map(
            each -> {
              String owner = String.join("::", each.owner());
              var range = text.lines().range(each.start(), each.end());
              return new Call.Item(
                  each.key(),
                  owner,
                  ElementKind.INVARIANT,
                  new FileRange(text.file(), range),
                  range);
            });
  }

  @Override
  public List<FileRange> implementations(TextPosition position) {
    return mentionAt(position)
        .map(Mention::target)
        .filter(EClass.class::isInstance)
        .map(type -> declarationsBelow((EClass) type))
        .orElse(List.of());
  }

  @Override
  public List<Symbol> symbols() {
    return symbols(1);
  }

  /** Returns the elements at a depth of the file, with those in them. */
  private List<Symbol> symbols(int depth) {
    return children(List.of(), depth);
  }

  private List<Symbol> children(List<String> outer, int depth) {
    List<Symbol> symbols = new ArrayList<>();
    for (MetamodelText.Named each : text.elements()) {
      boolean inside =
          each.path().size() == depth && each.path().subList(0, depth - 1).equals(outer);
      if (inside && !each.tag().equals("eParameters")) {
        List<Symbol> children = children(each.path(), depth + 1);
        int last =
            Stream.concat(
                    Stream.of(each.end()),
                    children.stream().map(child -> text.lines().offset(child.range().end())))
                .max(Integer::compare)
                .orElseThrow();
        symbols.add(
            new Symbol(
                each.name(),
                "",
                kindOf(each),
                text.lines().range(each.tagStart(), last),
                text.lines().range(each.start(), each.end()),
                children));
      }
    }
    return symbols;
  }

  private ElementKind kindOf(MetamodelText.Named named) {
    int end = text.source().text().indexOf('>', named.tagStart());
    String tag = text.source().text().substring(named.tagStart(), Math.max(end, named.start()));
    return switch (named.tag()) {
      case "eClassifiers" ->
          tag.contains("ecore:EEnum")
              ? ElementKind.ENUMERATION
              : tag.contains("ecore:EDataType") ? ElementKind.DATA_TYPE : ElementKind.CLASS;
      case "eStructuralFeatures" ->
          tag.contains("ecore:EReference") ? ElementKind.REFERENCE : ElementKind.ATTRIBUTE;
      case "eOperations" -> ElementKind.OPERATION;
      case "eLiterals" -> ElementKind.ENUMERATION_LITERAL;
      default -> ElementKind.PACKAGE;
    };
  }

  @Override
  public List<Folding> foldings() {
    return List.of();
  }

  @Override
  public List<SemanticToken> tokens() {
    ExpressionTokens tokens = new ExpressionTokens(text.lines(), language().packages(), Set.of());
    places().forEach(each -> tokens.addAll(each.range()));
    return List.copyOf(tokens.found());
  }
}
