package dev.eventchain.ocl;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.ocl.metamodel.Names;
import dev.eventchain.ocl.metamodel.OclAnnotations;
import dev.eventchain.ocl.tree.InvalidOrigin;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.eclipse.emf.common.util.URI;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.EParameter;
import org.eclipse.emf.ecore.ETypedElement;
import org.eclipse.ocl.Environment;
import org.eclipse.ocl.expressions.OCLExpression;

/**
 * The bodies of features and operations of metamodels, from documents and from annotations; the
 * latter are parsed when first needed.
 */
final class MemberBodies {

  private final ExpressionLanguage language;
  private final Map<ETypedElement, Optional<OCLExpression<EClassifier>>> known = new HashMap<>();

  MemberBodies(ExpressionLanguage language) {
    this.language = language;
  }

  /** Returns the body of a feature or an operation. */
  Optional<OCLExpression<EClassifier>> of(ETypedElement member) {
    if (!known.containsKey(member)) {
      known.put(member, Optional.empty());
      OclAnnotations.body(member)
          .map(text -> SourceText.within(placeOf(member), text.value()).whole())
          .ifPresent(text -> implement(member, null, text, new ArrayList<>()));
    }
    return known.get(member);
  }

  /** Returns the file of a metamodel, since its lines are unknown to mere users of its members. */
  private static SourceLocation placeOf(ETypedElement member) {
    URI uri = member.eResource() == null ? null : member.eResource().getURI();
    return uri != null && uri.isFile()
        ? SourceLocation.of(Path.of(uri.toFileString()))
        : SourceLocation.NONE;
  }

  /**
   * Sets the body of a feature or an operation of a metamodel, which sees {@code self} and the
   * parameters. With an error in it, every use is invalid.
   *
   * @param parameters the names of the parameters in the body; {@code null} for their own names
   */
  void implement(
      ETypedElement member, List<String> parameters, SourceRange text, List<Diagnostic> problems) {
    EClass owner = (EClass) member.eContainer();
    Scope scope = Scope.EMPTY.in(owner.getEPackage()).with(Environment.SELF_VARIABLE_NAME, owner);
    if (member instanceof EOperation operation) {
      for (int i = 0; i < operation.getEParameters().size(); i++) {
        EParameter parameter = operation.getEParameters().get(i);
        String name = parameters == null ? parameter.getName() : parameters.get(i);
        scope = scope.with(name, language.typeOf(parameter));
      }
    }
    List<Diagnostic> found = new ArrayList<>();
    Optional<OCLExpression<EClassifier>> body = language.parse(text, scope, member, found);
    known.put(member, Optional.of(body.orElseGet(() -> invalid(member, text, found))));
    problems.addAll(found);
  }

  private OCLExpression<EClassifier> invalid(
      ETypedElement member, SourceRange text, List<Diagnostic> errors) {
    SourceText invalid = SourceText.within(text.location(), "invalid");
    String reason =
        errors.stream()
            .filter(each -> Diagnostic.anyError(List.of(each)))
            .findFirst()
            .map(error -> ": " + error.message().replaceFirst("\\.$", ""))
            .orElse("");
    OCLExpression<EClassifier> body =
        language.parse(invalid.whole(), Scope.EMPTY, member, new ArrayList<>()).orElseThrow();
    body.eAdapters().clear();
    String what = "the expression of '" + Names.of(member) + "' has an error" + reason;
    body.eAdapters().add(new InvalidOrigin.Source(invalid, what));
    return body;
  }
}
