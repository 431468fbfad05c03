package dev.eventchain.constraints;

import dev.eventchain.constraints.document.DocumentImports;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.ocl.ExpressionLanguage;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import java.util.stream.StreamSupport;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EDataType;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.util.EcoreUtil;

/**
 * Invariants and definitions from Complete OCL documents, parsed and checked against metamodels.
 * Immutable and thread-safe.
 *
 * <p>Without a {@code package} clause, the classes of a document are looked up in all given
 * packages. {@code import} lines must name a given metamodel or document. A definition can be used
 * before its declaration and in other documents. An identical invariant in several documents counts
 * once. Comments above an invariant set how its violations are reported: {@code -- @severity
 * warning}, {@code -- @message {self.name} is wrong}, {@code -- @hint ...}.
 */
public final class OclRules {

  private final List<OclConstraint> constraints;
  private final List<Diagnostic> diagnostics;

  private final List<String> documents;

  OclRules(List<OclConstraint> constraints, List<Diagnostic> diagnostics, List<String> documents) {
    this.documents = List.copyOf(documents);
    this.constraints = List.copyOf(constraints);
    this.diagnostics = List.copyOf(diagnostics);
  }

  /**
   * Returns documents and those that they import, {@code import 'other.ocl'}: each once, the given
   * ones first. An import that is not a file is left to {@link #parse}, which reports it.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException INPUT if a file cannot be read
   */
  public static List<Path> files(List<Path> documents) {
    return DocumentImports.files(documents);
  }

  /**
   * Parses and checks documents.
   *
   * @param documents the documents, which see each other's definitions
   * @param packages the metamodels; nested packages need not be listed
   * @return the rules without those that have an error; {@link #diagnostics()} has the errors
   */
  public static OclRules parse(List<SourceText> documents, Collection<EPackage> packages) {
    return new RuleParser(ExpressionLanguage.of(packages)).parse(documents);
  }

  /**
   * As {@link #parse(List, Collection)}, preceded by the invariants in annotations of the
   * metamodels.
   *
   * @param places returns the location of an element of a metamodel
   */
  public static OclRules parse(
      List<SourceText> documents,
      Collection<EPackage> packages,
      Function<EObject, SourceLocation> places) {
    return new RuleParser(ExpressionLanguage.of(packages)).parse(documents, places);
  }

  /** Returns all errors and warnings of the documents, in the order of their places. */
  public List<Diagnostic> diagnostics() {
    return diagnostics;
  }

  /** Returns the names of the documents. */
  List<String> documents() {
    return documents;
  }

  /** Returns the invariants without errors, in the order of the documents. */
  public List<OclConstraint> constraints() {
    return constraints;
  }

  /** Returns the qualified names of the invariants without errors: {@code Class::Name}. */
  public List<String> constraintNames() {
    return constraints.stream().map(OclConstraint::qualifiedName).toList();
  }

  /**
   * Returns whether some invariant applies to an element, its contents, or a value that one of them
   * stores. Stops at the first such element.
   */
  public boolean areAbout(EObject root) {
    List<EClassifier> contexts =
        constraints.stream().<EClassifier>map(OclConstraint::context).distinct().toList();
    Iterable<EObject> inside = () -> EcoreUtil.getAllProperContents(root, false);
    return Stream.concat(Stream.of(root), StreamSupport.stream(inside.spliterator(), false))
        .anyMatch(element -> contexts.stream().anyMatch(type -> isAbout(type, element)));
  }

  private static boolean isAbout(EClassifier type, EObject element) {
    return type instanceof EDataType values
        ? !HeldValue.of(values, List.of(element)).isEmpty()
        : type.isInstance(element);
  }

  /** Returns the invariant of a qualified name. */
  public Optional<OclConstraint> constraint(String qualifiedName) {
    return constraints.stream().filter(c -> c.qualifiedName().equals(qualifiedName)).findFirst();
  }
}
