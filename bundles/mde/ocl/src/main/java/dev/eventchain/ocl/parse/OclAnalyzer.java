package dev.eventchain.ocl.parse;

import dev.eventchain.ocl.text.ExpressionRules;
import dev.eventchain.ocl.tree.BigLiterals;
import dev.eventchain.ocl.tree.SafeNavigation;
import java.util.List;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EEnumLiteral;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EParameter;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.ocl.Environment;
import org.eclipse.ocl.cst.CSTNode;
import org.eclipse.ocl.cst.CallExpCS;
import org.eclipse.ocl.cst.ClassifierContextDeclCS;
import org.eclipse.ocl.cst.CollectionTypeCS;
import org.eclipse.ocl.cst.FeatureCallExpCS;
import org.eclipse.ocl.cst.IntegerLiteralExpCS;
import org.eclipse.ocl.cst.LoopExpCS;
import org.eclipse.ocl.cst.OperationCallExpCS;
import org.eclipse.ocl.cst.SimpleNameCS;
import org.eclipse.ocl.cst.VariableCS;
import org.eclipse.ocl.ecore.CallOperationAction;
import org.eclipse.ocl.ecore.Constraint;
import org.eclipse.ocl.ecore.SendSignalAction;
import org.eclipse.ocl.ecore.parser.OCLAnalyzer;
import org.eclipse.ocl.expressions.IntegerLiteralExp;
import org.eclipse.ocl.expressions.LoopExp;
import org.eclipse.ocl.expressions.OCLExpression;
import org.eclipse.ocl.expressions.OperationCallExp;
import org.eclipse.ocl.expressions.Variable;
import org.eclipse.ocl.parser.OCLLexer;
import org.eclipse.ocl.utilities.TypedElement;

/** Parses text to a checked expression. */
public final class OclAnalyzer extends OCLAnalyzer {

  private record MissingOperation(
      EClassifier owner,
      String name,
      List<? extends TypedElement<EClassifier>> arguments,
      CSTNode node) {}

  private final SafeDots safe;
  private MissingOperation missing;

  public OclAnalyzer(OclEnvironment environment, String input) {
    this(environment, new SafeDots(input));
  }

  private OclAnalyzer(OclEnvironment environment, SafeDots safe) {
    super(new BigLiterals.Parser(new OCLLexer(environment, safe.plain().toCharArray())));
    this.safe = safe;
    getLexer().lexer(getAbstractParser().getIPrsStream());
    KeywordNames.release(getAbstractParser().getIPrsStream(), environment.packages());
    NewerSyntax.spellOut(getAbstractParser().getIPrsStream());
  }

  @Override
  protected IntegerLiteralExp<EClassifier> integerLiteralExpCS(
      IntegerLiteralExpCS node,
      Environment<
              EPackage,
              EClassifier,
              EOperation,
              EStructuralFeature,
              EEnumLiteral,
              EParameter,
              EObject,
              CallOperationAction,
              SendSignalAction,
              Constraint,
              EClass,
              EObject>
          environment) {
    IntegerLiteralExp<EClassifier> literal = super.integerLiteralExpCS(node, environment);
    BigLiterals.complete(literal, node.getSymbol());
    return literal;
  }

  /** Gives a variable without a type that of its value. */
  @Override
  protected Variable<EClassifier, EParameter> variableDeclarationCS(
      VariableCS node,
      Environment<
              EPackage,
              EClassifier,
              EOperation,
              EStructuralFeature,
              EEnumLiteral,
              EParameter,
              EObject,
              CallOperationAction,
              SendSignalAction,
              Constraint,
              EClass,
              EObject>
          environment,
      boolean add) {
    if (NewerSyntax.isTyped(node)) {
      return super.variableDeclarationCS(node, environment, add);
    }
    OCLExpression<EClassifier> value = oclExpressionCS(node.getInitExpression(), environment);
    String rule = "variableDeclarationCS";
    EClassifier type = value == null ? null : value.getType(); // a value with errors
    Variable<EClassifier, EParameter> variable =
        genVariableDeclaration(
            node, rule, environment, node.getName(), type, value, true, add, false);
    initStartEndPositions(variable, node);
    return variable;
  }

  /** Marks a call that is written with a question mark. */
  @Override
  protected OCLExpression<EClassifier> propertyCallExpCS(
      CallExpCS node,
      Environment<
              EPackage,
              EClassifier,
              EOperation,
              EStructuralFeature,
              EEnumLiteral,
              EParameter,
              EObject,
              CallOperationAction,
              SendSignalAction,
              Constraint,
              EClass,
              EObject>
          environment) {
    OCLExpression<EClassifier> call = super.propertyCallExpCS(node, environment);
    if (call != null
        && node.getSource() != null
        && safe.between(node.getSource().getEndOffset(), startOf(node))) {
      SafeNavigation.mark(call);
    }
    return call;
  }

  /** Returns where the name of what is called begins. */
  private static int startOf(CallExpCS node) {
    CSTNode name =
        node.getSimpleNameCS() != null || !(node instanceof FeatureCallExpCS call)
            ? node.getSimpleNameCS()
            : call.getPathNameCS();
    return name == null ? node.getEndOffset() : name.getStartOffset();
  }

  /** Refuses two variables of one name in a loop; an inner loop may hide an outer one's. */
  @Override
  protected LoopExp<EClassifier, EParameter> loopExpCS(
      LoopExpCS node,
      Environment<
              EPackage,
              EClassifier,
              EOperation,
              EStructuralFeature,
              EEnumLiteral,
              EParameter,
              EObject,
              CallOperationAction,
              SendSignalAction,
              Constraint,
              EClass,
              EObject>
          environment) {
    VariableCS first = node.getVariable1();
    VariableCS second = node.getVariable2();
    boolean same = first != null && second != null && first.getName().equals(second.getName());
    if (same) {
      String message = "Both variables of the loop are called '" + first.getName() + "'.";
      collector().add(ExpressionRules.TYPE, true, message, "Rename one.", second.getStartOffset());
    }
    return super.loopExpCS(node, environment);
  }

  /** Keeps the environment, which already has its {@code self} or is meant to have none. */
  @Override
  protected Environment<
          EPackage,
          EClassifier,
          EOperation,
          EStructuralFeature,
          EEnumLiteral,
          EParameter,
          EObject,
          CallOperationAction,
          SendSignalAction,
          Constraint,
          EClass,
          EObject>
      createClassifierContext(
          Environment<
                  EPackage,
                  EClassifier,
                  EOperation,
                  EStructuralFeature,
                  EEnumLiteral,
                  EParameter,
                  EObject,
                  CallOperationAction,
                  SendSignalAction,
                  Constraint,
                  EClass,
                  EObject>
              environment,
          ClassifierContextDeclCS context,
          EClassifier classifier) {
    return environment;
  }

  /** Reads the type of a collection where a type is expected; reports another unknown name. */
  @Override
  protected OCLExpression<EClassifier> simpleUndefinedName(
      SimpleNameCS name,
      Environment<
              EPackage,
              EClassifier,
              EOperation,
              EStructuralFeature,
              EEnumLiteral,
              EParameter,
              EObject,
              CallOperationAction,
              SendSignalAction,
              Constraint,
              EClass,
              EObject>
          environment,
      OCLExpression<EClassifier> source,
      String simpleName) {
    if (source == null && name instanceof CollectionTypeCS type) {
      return typeCS(name, environment, collectionTypeCS(type, environment));
    }
    ProblemTexts.Problem problem =
        source == null
            ? texts().unknownName(simpleName, environment)
            : texts().unknownFeature(simpleName, source.getType());
    if (source != null && texts().isError(source.getType()) && collector().failed()) {
      return createDummyInvalidLiteralExp(environment, name);
    }
    if (collector().isAt('"', name.getStartOffset())) {
      problem =
          new ProblemTexts.Problem(problem.message(), "Strings are written in single quotes.");
    }
    reportMissing(simpleName, problem, name.getStartOffset());
    return createDummyInvalidLiteralExp(environment, name);
  }

  /** Records a failed lookup for the error that follows. */
  @Override
  protected EOperation lookupOperation(
      CSTNode node,
      Environment<
              EPackage,
              EClassifier,
              EOperation,
              EStructuralFeature,
              EEnumLiteral,
              EParameter,
              EObject,
              CallOperationAction,
              SendSignalAction,
              Constraint,
              EClass,
              EObject>
          environment,
      EClassifier owner,
      String name,
      List<? extends TypedElement<EClassifier>> arguments) {
    EOperation found = super.lookupOperation(node, environment, owner, name, arguments);
    missing =
        found == null && node != null ? new MissingOperation(owner, name, arguments, node) : null;
    return found;
  }

  @Override
  protected OperationCallExp<EClassifier, EOperation> genOperationCallExp(
      Environment<
              EPackage,
              EClassifier,
              EOperation,
              EStructuralFeature,
              EEnumLiteral,
              EParameter,
              EObject,
              CallOperationAction,
              SendSignalAction,
              Constraint,
              EClass,
              EObject>
          environment,
      OperationCallExpCS node,
      String rule,
      String name,
      OCLExpression<EClassifier> source,
      EClassifier ownerType,
      List<OCLExpression<EClassifier>> arguments) {
    OperationCallExp<EClassifier, EOperation> call =
        super.genOperationCallExp(environment, node, rule, name, source, ownerType, arguments);
    if (call.getReferredOperation() != null
        && arguments != null
        && arguments.size() == 1
        && hasItsType(source)
        && hasItsType(arguments.get(0))) {
      texts()
          .senselessComparison(name, ownerType, arguments.get(0).getType())
          .ifPresent(problem -> warn(problem, node.getSimpleNameCS().getStartOffset()));
    }
    return call;
  }

  private static boolean hasItsType(OCLExpression<EClassifier> expression) {
    return !(expression instanceof OperationCallExp<?, ?> call
        && call.getReferredOperation() instanceof Libraries.LibraryOperation operation
        && operation.implementation().mayGiveOtherTypes());
  }

  @Override
  public void ERROR(Object node, String rule, String message) {
    MissingOperation wanted = missing;
    missing = null;
    if (wanted != null) {
      if (!texts().isError(wanted.owner()) && !isOfError(wanted)) {
        reportMissing(
            wanted.name(),
            texts().unknownOperation(wanted.owner(), wanted.name(), wanted.arguments()),
            wanted.node().getStartOffset());
      } else if (!collector().failed()) {
        super.ERROR(node, rule, message);
      }
    } else if (node instanceof OperationCallExpCS call
        && call.getSource() == null
        && message.startsWith("illegal operation signature")) {
      reportMissing(
          call.getSimpleNameCS().getValue(),
          texts().unknownFunction(call.getSimpleNameCS().getValue(), message),
          call.getStartOffset());
    } else if (node instanceof CSTNode place) {
      ProblemTexts.duplicate(message)
          .ifPresentOrElse(
              problem ->
                  collector()
                      .add(
                          ExpressionRules.DUPLICATE,
                          true,
                          problem.message(),
                          problem.hint(),
                          place.getStartOffset()),
              () -> report(texts().other(message), place.getStartOffset()));
    } else {
      super.ERROR(node, rule, message);
    }
  }

  /** Returns whether a lookup failed only because of another error. */
  private boolean isOfError(MissingOperation wanted) {
    return collector().failed() && ProblemTexts.isAnyError(wanted.arguments());
  }

  /** Reports a missing name, unless it is that of a definition with an error. */
  private void reportMissing(String name, ProblemTexts.Problem problem, int offset) {
    if (((OclEnvironment) getEnvironment()).hasFailed(name)) {
      collector().fail();
    } else {
      report(problem, offset);
    }
  }

  private void report(ProblemTexts.Problem problem, int offset) {
    collector().add(ExpressionRules.TYPE, true, problem.message(), problem.hint(), offset);
  }

  private void warn(ProblemTexts.Problem problem, int offset) {
    collector().add(ExpressionRules.TYPE, false, problem.message(), problem.hint(), offset);
  }

  private ProblemCollector collector() {
    return (ProblemCollector) ((OclEnvironment) getEnvironment()).getProblemHandler();
  }

  private ProblemTexts texts() {
    return ((OclEnvironment) getEnvironment()).texts();
  }
}
