package dev.eventchain.ocl.parse;

import dev.eventchain.ocl.dialect.Dialect;
import dev.eventchain.ocl.metamodel.Names;
import dev.eventchain.ocl.metamodel.PackageIndex;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EParameter;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.ETypedElement;
import org.eclipse.emf.ecore.EcorePackage;
import org.eclipse.ocl.AmbiguousLookupException;
import org.eclipse.ocl.LookupException;
import org.eclipse.ocl.cst.CSTNode;
import org.eclipse.ocl.cst.CallExpCS;
import org.eclipse.ocl.ecore.EcoreEnvironment;
import org.eclipse.ocl.ecore.TypeType;
import org.eclipse.ocl.expressions.OCLExpression;
import org.eclipse.ocl.expressions.Variable;
import org.eclipse.ocl.lpg.ProblemHandler;
import org.eclipse.ocl.options.ParsingOptions;
import org.eclipse.ocl.options.ProblemOption;
import org.eclipse.ocl.utilities.TypedElement;

/**
 * The names that an expression can use while it is parsed. Unlike its superclass, it finds types in
 * all packages and operations in libraries, and gives all errors the place of their node.
 */
public final class OclEnvironment extends EcoreEnvironment {

  static {
    StandardTypes.complete();
  }

  private final OclEnvironmentFactory factory;

  /** Variables that others hide, the innermost first, by name. */
  private final Map<String, Deque<Variable<EClassifier, EParameter>>> hidden = new HashMap<>();

  /** True while a variable that was hidden is added again. */
  private boolean restoring;

  /** True while parsing the type of a declaration. */
  private boolean declaring;

  OclEnvironment(OclEnvironmentFactory factory) {
    super(factory, null);
    this.factory = factory;
    setOption(ParsingOptions.implicitRootClass(this), EcorePackage.Literals.EOBJECT);
    setOption(ParsingOptions.USE_LONG_INTEGERS, true);
    // toUpper and toUpperCase were both standard at some time, and are the same.
    setOption(ProblemOption.STRING_CASE_CONVERSION, ProblemHandler.Severity.OK);
  }

  OclEnvironment(OclEnvironment parent) {
    super(parent);
    this.factory = parent.factory;
    this.declaring = parent.declaring;
    if (parent.getInternalParent() != null) {
      // All environments of one parse share the mapping from nodes to places.
      setASTNodeToCSTNodeMap(parent.getASTNodeToCSTNodeMap());
    }
  }

  /** Sets the package in which simple names are looked up first. */
  public void setPackage(EPackage contextPackage) {
    setContextPackage(contextPackage);
  }

  /** Parses type names as those of a declaration from now on, which may mean any type. */
  public void declareTypes() {
    declaring = true;
  }

  /** Adds a variable; {@code self} is the implicit source of calls and navigations. */
  public void addVariable(String name, EClassifier type) {
    Variable<EClassifier, EParameter> variable = getOCLFactory().createVariable();
    getUMLReflection().setName(variable, name);
    getUMLReflection().setType(variable, getUMLReflection().asOCLType(type));
    addVariable(variable);
  }

  /** Adds a variable that belongs to a definition. */
  public void addVariable(Variable<EClassifier, EParameter> variable) {
    if (addElement(variable.getName(), variable, true)
        && variable.getName().equals(SELF_VARIABLE_NAME)) {
      setSelfVariable(variable);
    }
  }

  /** Adds a variable, which hides another one of its name until it is deleted. */
  @Override
  public boolean addElement(
      String name, Variable<EClassifier, EParameter> variable, boolean isExplicit) {
    Variable<EClassifier, EParameter> outer = name == null ? null : lookupLocal(name);
    if (outer != null) {
      hidden.computeIfAbsent(name, each -> new ArrayDeque<>()).push(outer);
      super.deleteElement(name);
    }
    return super.addElement(name, variable, isExplicit);
  }

  @Override
  public void deleteElement(String name) {
    super.deleteElement(name);
    Deque<Variable<EClassifier, EParameter>> outer = hidden.get(name);
    if (outer != null && !outer.isEmpty()) {
      restoring = true;
      super.addElement(name, outer.pop(), true);
      restoring = false;
    }
  }

  /** Gives a new variable a container; one that was hidden has got its loop by now. */
  @Override
  protected void addedVariable(
      String name, Variable<EClassifier, EParameter> variable, boolean isExplicit) {
    if (!restoring) {
      super.addedVariable(name, variable, isExplicit);
    }
  }

  /** Records a definition as static: {@code Type::name(...)}. */
  public void addStatic(Object definition) {
    factory.statics().add(definition);
  }

  public boolean hasStatic(String name) {
    return factory.statics().stream().anyMatch(each -> name.equals(Names.of(each)));
  }

  public boolean isStatic(Object definition) {
    return factory.statics().contains(definition);
  }

  /**
   * Records a definition that could not be declared, so that its uses are no errors of their own.
   */
  public void addFailedName(String name) {
    factory.failedNames().add(name);
  }

  boolean hasFailed(String name) {
    return factory.failedNames().contains(name);
  }

  public void forgetFailedNames() {
    factory.failedNames().clear();
  }

  /** Sets a placeholder for {@code self}, which the analyzer needs for an expression without. */
  public void hideSelf() {
    Variable<EClassifier, EParameter> hidden = getOCLFactory().createVariable();
    getUMLReflection().setName(hidden, Libraries.NO_SOURCE);
    getUMLReflection().setType(hidden, factory.libraries().functions());
    setSelfVariable(hidden);
  }

  /** Removes leftovers of a parse, which later parses would have to search. */
  public void clean() {
    getTypeResolver().getResource().getContents().removeIf(root -> !(root instanceof EPackage));
  }

  /** Returns the operations and properties that definitions have added to a class. */
  public List<Object> definitionsOf(EClassifier type) {
    List<Object> definitions = new ArrayList<>(getTypeResolver().getAdditionalOperations(type));
    definitions.addAll(getTypeResolver().getAdditionalAttributes(type));
    return definitions;
  }

  /** Returns the operations and features that a class declares, and those added by definitions. */
  public List<ETypedElement> membersOf(EClass type) {
    List<ETypedElement> members = new ArrayList<>(type.getEOperations());
    members.addAll(getTypeResolver().getAdditionalOperations(type));
    members.addAll(type.getEStructuralFeatures());
    members.addAll(getTypeResolver().getAdditionalAttributes(type));
    return members;
  }

  /** Returns the body of a feature or an operation; null if there is none. */
  public OCLExpression<EClassifier> bodyOf(ETypedElement element) {
    return factory.bodyOf(element);
  }

  ProblemTexts texts() {
    return factory.texts();
  }

  public PackageIndex packages() {
    return factory.packages();
  }

  public Dialect dialect() {
    return factory.dialect();
  }

  public Libraries libraries() {
    return factory.libraries();
  }

  /** Finds a type; one that several packages have must be named with its package. */
  @Override
  public EClassifier tryLookupClassifier(List<String> names) throws LookupException {
    if (!dialect().takesFirstType() && nearest(names) == null) {
      List<EClassifier> candidates = factory.packages().classifiers(names);
      if (candidates.size() > 1) {
        String all = candidates.stream().map(Names::qualified).collect(Collectors.joining(", "));
        throw new AmbiguousLookupException(
            "Several types are called '" + String.join("::", names) + "': " + all + ".",
            candidates);
      }
    }
    return super.tryLookupClassifier(names);
  }

  /** Returns the number of roots in the type resolver. */
  public int roots() {
    return getTypeResolver().getResource().getContents().size();
  }

  @Override
  public EClassifier lookupClassifier(List<String> names) {
    EClassifier found = nearest(names);
    if (found != null) {
      return found;
    }
    List<EClassifier> candidates = factory.packages().classifiers(names);
    if (!candidates.isEmpty()) {
      return candidates.get(0);
    }
    EClassifier other = super.lookupClassifier(names);
    boolean any =
        other == null && declaring && names.size() == 1 && dialect().meansAnyType(names.get(0));
    return any ? getOCLStandardLibrary().getOclAny() : other;
  }

  /**
   * Finds a type from inside the context's package and those around it. Eclipse OCL would silently
   * take the first package of that name anywhere.
   */
  private EClassifier nearest(List<String> names) {
    if (names.size() == 1) {
      return super.lookupClassifier(names);
    }
    EClassifier found = null;
    for (EPackage each = getContextPackage(); each != null && found == null; ) {
      found = PackageIndex.classifierIn(each, names);
      each = each.getESuperPackage();
    }
    return found;
  }

  @Override
  public EOperation lookupOperation(
      EClassifier owner, String name, List<? extends TypedElement<EClassifier>> args) {
    if (owner != null) {
      EOperation found = factory.libraries().lookup(owner, name, args, false);
      if (found != null) {
        return found;
      }
    }
    if (owner instanceof TypeType type) {
      EOperation found = super.lookupOperation(type.getReferredType(), name, args);
      if (isStatic(found)) {
        return found;
      }
    }
    EOperation found = super.lookupOperation(owner, name, args);
    if (found == null && owner != null) {
      return LooseTypes.operation(this, owner, name, args);
    }
    return isOverridden(owner, found) ? null : found;
  }

  /** Returns whether a definition being declared may override a member found in a superclass. */
  private boolean isOverridden(EClassifier owner, ETypedElement found) {
    return factory.isDeclaring()
        && owner instanceof EClass type
        && !membersOf(type).contains(found);
  }

  @Override
  public void validatorError(String message, String context, Object problem) {
    addTypeError(message, problem);
  }

  @Override
  public void utilityError(String message, String context, Object problem) {
    addTypeError(message, problem);
  }

  /** Adds an error at the name of the call, rather than at the start of its source. */
  private void addTypeError(String message, Object problem) {
    CSTNode node = problem instanceof CSTNode itself ? itself : getASTMapping(problem);
    if (node instanceof CallExpCS call && call.getSimpleNameCS() != null) {
      node = call.getSimpleNameCS();
    }
    int start = node == null ? -1 : node.getStartOffset();
    int end = node == null ? -1 : node.getEndOffset();
    getProblemHandler().analyzerProblem(ProblemHandler.Severity.ERROR, message, "", start, end);
  }

  @Override
  public EStructuralFeature lookupProperty(EClassifier owner, String name) {
    EStructuralFeature found = super.lookupProperty(owner, name);
    boolean stored = found != null && getDefinition(found) == null;
    return !stored && isOverridden(owner, found) ? null : found;
  }

  @Override
  public Variable<EClassifier, EParameter> lookupImplicitSourceForOperation(
      String name, List<? extends TypedElement<EClassifier>> args) {
    Libraries libraries = libraries();
    if (libraries.lookup(libraries.functions(), name, args, false) != null
        || libraries.lookup(libraries.functions(), name, args, true) != null) {
      Variable<EClassifier, EParameter> none = getOCLFactory().createVariable();
      getUMLReflection().setName(none, Libraries.NO_SOURCE);
      getUMLReflection().setType(none, libraries.functions());
      return none;
    }
    return super.lookupImplicitSourceForOperation(name, args);
  }
}
