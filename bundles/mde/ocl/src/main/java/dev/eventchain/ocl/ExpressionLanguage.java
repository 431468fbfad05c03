package dev.eventchain.ocl;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.ocl.dialect.Dialect;
import dev.eventchain.ocl.dialect.TypeSystem;
import dev.eventchain.ocl.lower.Lowering;
import dev.eventchain.ocl.metamodel.Names;
import dev.eventchain.ocl.metamodel.PackageIndex;
import dev.eventchain.ocl.model.ModelAccess;
import dev.eventchain.ocl.nodes.Lowered;
import dev.eventchain.ocl.parse.FrequentMistakes;
import dev.eventchain.ocl.parse.OclEnvironment;
import dev.eventchain.ocl.parse.OclEnvironmentFactory;
import dev.eventchain.ocl.parse.StringLiterals;
import dev.eventchain.ocl.text.ExpressionRules;
import dev.eventchain.ocl.text.Lexer;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EParameter;
import org.eclipse.emf.ecore.ETypedElement;
import org.eclipse.emf.ecore.EcorePackage;
import org.eclipse.ocl.Environment;
import org.eclipse.ocl.ecore.Constraint;
import org.eclipse.ocl.ecore.TypeType;
import org.eclipse.ocl.expressions.CollectionKind;
import org.eclipse.ocl.expressions.LetExp;
import org.eclipse.ocl.expressions.OCLExpression;
import org.eclipse.ocl.expressions.Variable;
import org.eclipse.ocl.types.CollectionType;
import org.eclipse.ocl.util.TypeUtil;
import org.eclipse.ocl.utilities.ExpressionInOCL;

/**
 * OCL, or a {@link Dialect} of it, over some metamodels. Parses expressions; parsed ones can be
 * evaluated by several threads while another thread parses more.
 *
 * <p>Simple names of types are looked up in the packages in the given order, nested packages
 * included, and last in Ecore itself; {@code package::Type} works, too. Every object has the
 * operations of EObject. Types are those of classic Eclipse OCL, values those of OMG OCL 2.4 except
 * for some differences (see {@code differences.md}); in particular, {@code closure} omits its
 * source. A quote in a string is written {@code \'}.
 */
public final class ExpressionLanguage implements TypeSystem {

  private static final String EXPRESSION_PREFIX = "inv:\n";
  private static final String ANY_BODY = " null";
  private static final String TYPE_PREFIX = "inv:\nlet type : ";
  private static final String TYPE_SUFFIX = "\n = invalid in true";

  private final OclEnvironmentFactory factory;
  private final OclEnvironment root;
  private final ModelAccess model;
  private final Lowering lowering;

  /** Lowers expressions again to explain invalid values. */
  private final Lowering tracing;

  /** Cache of the types parsed by name. */
  private final Map<String, EClassifier> types = new HashMap<>();

  /** The bodies of features and operations of metamodels, parsed when needed. */
  private final MemberBodies bodies = new MemberBodies(this);

  private ExpressionLanguage(OclEnvironmentFactory factory) {
    this.factory = factory;
    factory.computeBy(this::bodyOf);
    factory.libraries().belongTo(this);
    this.root = factory.root();
    this.model = new ModelAccess(root);
    this.lowering = new Lowering(root, model, false);
    this.tracing = new Lowering(root, model, true);
  }

  /** Returns standard OCL over packages. */
  public static ExpressionLanguage of(Collection<EPackage> packages) {
    return of(packages, Dialect.STANDARD);
  }

  /** Returns a dialect of OCL over packages. */
  public static ExpressionLanguage of(Collection<EPackage> packages, Dialect dialect) {
    return new ExpressionLanguage(new OclEnvironmentFactory(new PackageIndex(packages), dialect));
  }

  /** Returns the scope without variables. */
  public Scope root() {
    return Scope.EMPTY;
  }

  /**
   * Parses and checks an expression.
   *
   * @param range the text of the expression
   * @param problems the list to add all errors and warnings to, with their places in the text
   * @return empty if there is an error
   */
  public synchronized Optional<Expression> parse(
      SourceRange range, Scope scope, List<Diagnostic> problems) {
    return parse(range, scope.prefix(), environment(scope), problems)
        .map(ast -> new Expression(this, ast));
  }

  private Optional<OCLExpression<EClassifier>> parse(
      SourceRange range, String prefix, OclEnvironment environment, List<Diagnostic> problems) {
    if (range.text().isBlank()) {
      String missing = "An expression is missing here.";
      problems.add(Diagnostic.of(ExpressionRules.SYNTAX, missing, range.location()));
      return Optional.empty();
    }
    StringLiterals.check(range, problems);
    List<Diagnostic> mistakes = FrequentMistakes.in(range);
    problems.addAll(mistakes);
    if (!mistakes.isEmpty()) {
      return Optional.empty();
    }
    return parseConstraint(range, EXPRESSION_PREFIX + prefix, "", environment, problems);
  }

  /**
   * Adds an operation or a property to a class, for all expressions parsed from now on. {@link
   * #complete} must set its body before any of them is evaluated.
   *
   * @param signature from {@code def} to the equals sign
   * @return the operation or property; empty if the signature has an error
   */
  synchronized Optional<Object> declare(
      SourceRange signature, Scope scope, List<Diagnostic> problems) {
    EClassifier owner = scope.typeOf(Environment.SELF_VARIABLE_NAME);
    List<Object> before = root.definitionsOf(owner);
    OclEnvironment environment = environment(scope);
    boolean declared;
    factory.declare(true);
    try {
      declared = parseConstraint(signature, "", ANY_BODY, environment, problems).isPresent();
    } finally {
      factory.declare(false);
    }
    List<Object> added = root.definitionsOf(owner);
    added.removeAll(before);
    if (declared) {
      return Optional.of(added.get(0));
    }
    // Eclipse OCL keeps a feature whose signature could be parsed but has errors.
    added.forEach(root::undefine);
    return Optional.empty();
  }

  /** Sets the body of a declared operation or property; none if the body has an error. */
  synchronized void complete(
      Object feature, SourceRange text, Scope scope, List<Diagnostic> problems) {
    ExpressionInOCL<EClassifier, EParameter> definition =
        root.getDefinition(feature).getSpecification();
    Variable<EClassifier, EParameter> self = definition.getContextVariable();
    OclEnvironment environment = factory.createEnvironment(root);
    if (scope.home() != null) {
      environment.setPackage(scope.home());
    }
    if (root.isStatic(feature)) {
      environment.hideSelf();
    } else {
      environment.addVariable(self);
    }
    // An environment removes its variables from their containers; they are put back below.
    List<Variable<EClassifier, EParameter>> parameters =
        List.copyOf(definition.getParameterVariable());
    parameters.forEach(environment::addVariable);
    EClassifier declared = root.getUMLReflection().getOCLType(feature);
    Optional<OCLExpression<EClassifier>> body =
        parse(text, scope.prefix(), environment, problems)
            .filter(found -> hasType(found, feature, declared, text, problems));
    definition.setContextVariable(self);
    definition.getParameterVariable().addAll(parameters);
    definition.setBodyExpression(body.orElse(null));
  }

  /**
   * Sets the body of a feature or an operation of a metamodel, for all later evaluations; uses of
   * one with an error are invalid.
   *
   * @param parameters the names of the parameters in the body; {@code null} for their own names
   */
  public synchronized void implement(
      ETypedElement member, List<String> parameters, SourceRange text, List<Diagnostic> problems) {
    bodies.implement(member, parameters, text, problems);
  }

  /** Returns the body of a feature or an operation; null if there is none. */
  synchronized OCLExpression<EClassifier> bodyOf(ETypedElement member) {
    Constraint definition = root.getDefinition(member);
    return definition == null
        ? bodies.of(member).orElse(null)
        : definition.getSpecification().getBodyExpression();
  }

  /** Parses the body of a member; empty if it does not have the member's type. */
  Optional<OCLExpression<EClassifier>> parse(
      SourceRange text, Scope scope, ETypedElement member, List<Diagnostic> problems) {
    EClassifier declared = typeOf(member);
    return parse(text, "", environment(scope), problems)
        .filter(found -> hasType(found, member, declared, text, problems));
  }

  private boolean hasType(
      OCLExpression<EClassifier> body,
      Object feature,
      EClassifier declared,
      SourceRange range,
      List<Diagnostic> problems) {
    if (TypeUtil.compatibleTypeMatch(root, body.getType(), declared)) {
      return true;
    }
    String text = range.source().text();
    int first = range.start();
    while (first < range.end() && Lexer.isBlank(text, first)) {
      first = Lexer.end(text, first, range.end());
    }
    problems.add(
        Diagnostic.of(
            ExpressionRules.TYPE,
            "'"
                + Names.of(feature)
                + "' is declared as "
                + Names.of(declared)
                + ", but its value is of type "
                + Names.of(body.getType())
                + ".",
            range.source().at(first)));
    return false;
  }

  private Optional<OCLExpression<EClassifier>> parseConstraint(
      SourceRange range,
      String prefix,
      String suffix,
      OclEnvironment environment,
      List<Diagnostic> problems) {
    return ParsedText.read(range, prefix, suffix, environment, root, problems).valid();
  }

  /** Parses as much of an expression as can be understood, for editors; reports nothing. */
  synchronized Optional<OCLExpression<EClassifier>> understand(SourceRange range, Scope scope) {
    return ParsedText.read(
            range,
            EXPRESSION_PREFIX + scope.prefix(),
            "",
            environment(scope),
            root,
            new ArrayList<>())
        .understood();
  }

  private OclEnvironment environment(Scope scope) {
    OclEnvironment environment = factory.createEnvironment(root);
    if (scope.home() != null) {
      environment.setPackage(scope.home());
    }
    Set<String> seen = new HashSet<>();
    for (Scope each = scope; each.parent() != null; each = each.parent()) {
      if (seen.add(each.name())) {
        environment.addVariable(each.name(), each.type());
      }
    }
    if (!seen.contains(Environment.SELF_VARIABLE_NAME)) {
      environment.hideSelf();
    }
    return environment;
  }

  /**
   * Parses the name of a type: {@code String}, {@code Node}, {@code pkg::Node}, {@code
   * Sequence(Node)}, a tuple type.
   *
   * @return empty if there is an error
   */
  public synchronized Optional<EClassifier> type(SourceRange range, List<Diagnostic> problems) {
    String name = range.text().strip();
    EClassifier known = types.get(name);
    if (known != null) {
      return Optional.of(known);
    }
    int before = problems.size();
    OclEnvironment environment = environment(Scope.EMPTY);
    environment.declareTypes();
    Optional<EClassifier> type =
        parseConstraint(range, TYPE_PREFIX, TYPE_SUFFIX, environment, problems)
            .map(let -> ((LetExp<?, ?>) let).getVariable().getType())
            .map(EClassifier.class::cast);
    if (type.isPresent() && problems.size() == before) {
      types.put(name, type.get());
    }
    return type;
  }

  @Override
  public EClassifier type(String name) {
    List<Diagnostic> problems = new ArrayList<>();
    return type(SourceText.of("", name).whole(), problems)
        .orElseThrow(() -> new IllegalArgumentException(name + ": " + problems));
  }

  @Override
  public EClassifier type(EClassifier classifier) {
    return root.getUMLReflection().asOCLType(classifier);
  }

  /** Returns the type of a feature, an operation or a parameter, including its multiplicity. */
  EClassifier typeOf(ETypedElement element) {
    return root.getUMLReflection().getOCLType(element);
  }

  @Override
  public EClassifier sequenceOf(EClassifier elementType) {
    return collectionOf(CollectionKind.SEQUENCE_LITERAL, elementType);
  }

  @Override
  public EClassifier collectionLike(EClassifier collectionType, EClassifier elementType) {
    return collectionOf(((CollectionType<?, ?>) collectionType).getKind(), elementType);
  }

  private synchronized EClassifier collectionOf(CollectionKind kind, EClassifier elementType) {
    return (EClassifier) root.getTypeResolver().resolveCollectionType(kind, type(elementType));
  }

  @Override
  public Optional<EClassifier> elementType(EClassifier type) {
    return type instanceof CollectionType<?, ?> collection
        ? Optional.of((EClassifier) collection.getElementType())
        : Optional.empty();
  }

  @Override
  public Optional<EClassifier> referredType(EClassifier type) {
    return type instanceof TypeType literal
        ? Optional.ofNullable(literal.getReferredType())
        : Optional.empty();
  }

  @Override
  public synchronized boolean conforms(EClassifier type, EClassifier required) {
    return TypeUtil.compatibleTypeMatch(root, type(type), type(required));
  }

  @Override
  public boolean isInstance(Object value, EClassifier type) {
    return model.isKindOf(value, type);
  }

  @Override
  public EClassifier any() {
    return root.getOCLStandardLibrary().getOclAny();
  }

  @Override
  public EClassifier anyObject() {
    return EcorePackage.Literals.EOBJECT;
  }

  OclEnvironment environment() {
    return root;
  }

  /** Returns the packages that expressions can name. */
  public PackageIndex packages() {
    return factory.packages();
  }

  /** Compiles an expression; not during parsing, which may add definitions. */
  synchronized Lowered lower(OCLExpression<EClassifier> expression) {
    return lowering.lower(expression);
  }

  /** As {@link #lower}, into nodes that record why a value is invalid. */
  synchronized Lowered trace(OCLExpression<EClassifier> expression) {
    return tracing.lower(expression);
  }

  /** Returns what editors can know about expressions of this language. */
  public ExpressionAssistant assistant() {
    return new ExpressionAssistant(this);
  }
}
