package dev.eventchain.ocl.lower;

import dev.eventchain.ocl.nodes.DefinitionNodes;
import dev.eventchain.ocl.nodes.KeptValue;
import dev.eventchain.ocl.nodes.LoopNodes;
import dev.eventchain.ocl.nodes.Lowered;
import dev.eventchain.ocl.nodes.NavigationNodes;
import dev.eventchain.ocl.nodes.Node;
import dev.eventchain.ocl.nodes.TracedCondition;
import dev.eventchain.ocl.nodes.TracedNode;
import dev.eventchain.ocl.nodes.TracedVariable;
import dev.eventchain.ocl.nodes.ValueNodes;
import dev.eventchain.ocl.nodes.VirtualCall;
import dev.eventchain.ocl.parse.Libraries;
import dev.eventchain.ocl.tree.Asts;
import dev.eventchain.ocl.tree.BigLiterals;
import dev.eventchain.ocl.tree.SafeNavigation;
import dev.eventchain.ocl.values.Unlimited;
import dev.eventchain.ocl.values.Values;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EEnumLiteral;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.EParameter;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.ocl.expressions.BooleanLiteralExp;
import org.eclipse.ocl.expressions.CallExp;
import org.eclipse.ocl.expressions.CollectionItem;
import org.eclipse.ocl.expressions.CollectionKind;
import org.eclipse.ocl.expressions.CollectionLiteralExp;
import org.eclipse.ocl.expressions.CollectionLiteralPart;
import org.eclipse.ocl.expressions.CollectionRange;
import org.eclipse.ocl.expressions.EnumLiteralExp;
import org.eclipse.ocl.expressions.IfExp;
import org.eclipse.ocl.expressions.IntegerLiteralExp;
import org.eclipse.ocl.expressions.InvalidLiteralExp;
import org.eclipse.ocl.expressions.IterateExp;
import org.eclipse.ocl.expressions.IteratorExp;
import org.eclipse.ocl.expressions.LetExp;
import org.eclipse.ocl.expressions.NullLiteralExp;
import org.eclipse.ocl.expressions.OCLExpression;
import org.eclipse.ocl.expressions.OperationCallExp;
import org.eclipse.ocl.expressions.PropertyCallExp;
import org.eclipse.ocl.expressions.RealLiteralExp;
import org.eclipse.ocl.expressions.StringLiteralExp;
import org.eclipse.ocl.expressions.TupleLiteralExp;
import org.eclipse.ocl.expressions.TupleLiteralPart;
import org.eclipse.ocl.expressions.TypeExp;
import org.eclipse.ocl.expressions.UnlimitedNaturalLiteralExp;
import org.eclipse.ocl.expressions.Variable;
import org.eclipse.ocl.expressions.VariableExp;
import org.eclipse.ocl.types.CollectionType;
import org.eclipse.ocl.types.VoidType;

/** Lowers one expression, or the body of one definition. */
final class BodyLowering {

  private final Lowering lowering;
  private final boolean definition;
  private final OperationLowering operations;
  private final LoopLowering loops;

  /** Dependencies of values. */
  private final Purity purity;

  /** The visible variables and their slots. */
  private Map<String, Integer> visible = new LinkedHashMap<>();

  private final List<String> slots = new ArrayList<>();

  /** The variables that hold the sources of calls that are being lowered. */
  private final IdentityHashMap<OCLExpression<EClassifier>, Node> sources = new IdentityHashMap<>();

  /** The nodes of all expressions so far if tracing; otherwise null. */
  private final Map<OCLExpression<EClassifier>, Node> traced;

  /**
   * Creates the lowering of a body.
   *
   * @param parameters the only variables of a definition; null for an expression, which has those
   *     of its scope
   */
  BodyLowering(Lowering lowering, List<String> parameters) {
    this.lowering = lowering;
    this.definition = parameters != null;
    this.operations = new OperationLowering(this, lowering);
    this.purity = new Purity(lowering);
    // Tracing must visit all elements of a loop.
    Optional<KeyLowering> keys =
        lowering.isTracing() ? Optional.empty() : Optional.of(new KeyLowering(this, purity));
    this.loops = new LoopLowering(this, keys);
    this.traced = lowering.isTracing() ? new IdentityHashMap<>() : null;
    if (definition) {
      parameters.forEach(parameter -> visible.put(parameter, newSlot(null)));
    }
  }

  void lower(OCLExpression<EClassifier> expression, Lowered result) {
    Node root = node(expression);
    result.complete(root, slots.stream().map(BodyLowering::given).toList(), lowering.isRecursive());
  }

  /** Returns a free variable; null for that of calls without source, which never has a value. */
  private static String given(String variable) {
    return Libraries.NO_SOURCE.equals(variable) ? null : variable;
  }

  private int newSlot(String freeVariable) {
    slots.add(freeVariable);
    return slots.size() - 1;
  }

  /** Lowers an expression with additional variables. */
  Node within(Map<String, Integer> variables, OCLExpression<EClassifier> expression) {
    Map<String, Integer> outer = visible;
    visible = new LinkedHashMap<>(outer);
    // Removed first, so that the order is that of the scopes.
    visible.keySet().removeAll(variables.keySet());
    visible.putAll(variables);
    try {
      return node(expression);
    } finally {
      // Variables of the scope keep their slots once they have one.
      Map<String, Integer> inner = visible;
      visible = outer;
      inner.forEach(
          (name, slot) -> {
            if (slots.get(slot) != null) {
              visible.putIfAbsent(name, slot);
            }
          });
    }
  }

  int newSlot() {
    return newSlot(null);
  }

  Node[] nodes(List<OCLExpression<EClassifier>> expressions) {
    return expressions.stream().map(this::node).toArray(Node[]::new);
  }

  Node node(OCLExpression<EClassifier> expression) {
    Node known = sources.get(expression);
    if (known != null) {
      return known;
    }
    Node plain = plain(expression);
    Node node = traced == null ? plain : traced(expression, plain);
    if (purity.isOfModel(expression) && !isCollected(plain)) {
      node = new KeptValue(node);
    }
    if (traced != null) {
      traced.put(expression, node);
    }
    return node;
  }

  private Node traced(OCLExpression<EClassifier> expression, Node plain) {
    OCLExpression<EClassifier> subject = subjectOf(expression);
    return subject != null || expression instanceof InvalidLiteralExp<?>
        ? new TracedNode(expression, plain, traced.get(subject))
        : plain;
  }

  /** Returns whether a node collects the results of a library, which a caller may want to get. */
  private static boolean isCollected(Node node) {
    return node instanceof LoopNodes.Collect loop && loop.collectsCalls();
  }

  /** Returns the expression that a node is applied to; null if it only contains others. */
  @SuppressWarnings("unchecked") // Eclipse OCL's types have the metamodel as type arguments
  private static OCLExpression<EClassifier> subjectOf(OCLExpression<EClassifier> expression) {
    if (expression instanceof CallExp<?> call) {
      return (OCLExpression<EClassifier>) call.getSource();
    }
    return expression instanceof IfExp<?> choice
        ? (OCLExpression<EClassifier>) choice.getCondition()
        : null;
  }

  private Node plain(OCLExpression<EClassifier> expression) {
    return SafeNavigation.isSafe(expression) ? safe(expression) : unmarked(expression);
  }

  /** Lowers a call of which nothing is left if its source is null. */
  @SuppressWarnings("unchecked") // Eclipse OCL's types have the metamodel as type arguments
  private Node safe(OCLExpression<EClassifier> call) {
    OCLExpression<EClassifier> source = ((CallExp<EClassifier>) call).getSource();
    Node value = node(source);
    int slot = newSlot();
    sources.put(source, new ValueNodes.Slot(slot));
    Node of = unmarked(call);
    sources.remove(source);
    return source.getType() instanceof CollectionType<?, ?>
        ? new ValueNodes.Let(slot, new NavigationNodes.WithoutNull(value), of)
        : new ValueNodes.Let(slot, value, new NavigationNodes.UnlessNull(slot, of));
  }

  @SuppressWarnings("unchecked") // Eclipse OCL's types have the metamodel as type arguments
  private Node unmarked(OCLExpression<EClassifier> expression) {
    if (expression instanceof OperationCallExp<?, ?> call) {
      return operations.node((OperationCallExp<EClassifier, EOperation>) call);
    } else if (expression instanceof PropertyCallExp<?, ?> call) {
      return property((PropertyCallExp<EClassifier, EStructuralFeature>) call);
    } else if (expression instanceof VariableExp<?, ?> use) {
      return variable(use.getReferredVariable().getName());
    } else if (expression instanceof IteratorExp<?, ?> loop) {
      return loops.iterator((IteratorExp<EClassifier, EParameter>) loop);
    } else if (expression instanceof IterateExp<?, ?> loop) {
      return loops.iterate((IterateExp<EClassifier, EParameter>) loop);
    } else if (expression instanceof IfExp<?> choice) {
      return choice((IfExp<EClassifier>) choice);
    } else if (expression instanceof LetExp<?, ?> let) {
      return let((LetExp<EClassifier, EParameter>) let);
    } else if (expression instanceof CollectionLiteralExp<?> literal) {
      return collection((CollectionLiteralExp<EClassifier>) literal);
    } else if (expression instanceof TupleLiteralExp<?, ?> literal) {
      return tuple((TupleLiteralExp<EClassifier, EStructuralFeature>) literal);
    } else if (expression instanceof TypeExp<?> type) {
      return new ValueNodes.Constant(type.getReferredType());
    }
    return new ValueNodes.Constant(literal(expression));
  }

  /** Returns the value of a literal; invalid for those that parse but cannot be evaluated. */
  private Object literal(OCLExpression<EClassifier> expression) {
    if (expression instanceof IntegerLiteralExp<EClassifier> integer) {
      return BigLiterals.valueOf(integer);
    } else if (expression instanceof RealLiteralExp<?> real) {
      return real.getRealSymbol();
    } else if (expression instanceof StringLiteralExp<?> string) {
      return string.getStringSymbol();
    } else if (expression instanceof BooleanLiteralExp<?> truth) {
      return truth.getBooleanSymbol();
    } else if (expression instanceof EnumLiteralExp<?, ?> enumeration) {
      return ((EEnumLiteral) enumeration.getReferredEnumLiteral()).getInstance();
    } else if (expression instanceof UnlimitedNaturalLiteralExp<?>) {
      return Unlimited.UNLIMITED;
    }
    return expression instanceof NullLiteralExp<?> ? null : Values.INVALID;
  }

  private Node variable(String name) {
    Integer slot = visible.get(name);
    if (slot == null) {
      if (definition) {
        return new ValueNodes.Constant(null);
      }
      slot = newSlot(name);
      visible.put(name, slot);
    }
    return traced == null ? new ValueNodes.Slot(slot) : new TracedVariable.Use(slot);
  }

  private Node choice(IfExp<EClassifier> choice) {
    return new ValueNodes.Choice(
        node(choice.getCondition()),
        node(choice.getThenExpression()),
        node(choice.getElseExpression()));
  }

  private Node let(LetExp<EClassifier, EParameter> let) {
    Variable<EClassifier, EParameter> variable = let.getVariable();
    Node start = start(variable);
    int slot = newSlot();
    Node value = variableValue(slot, start);
    return new ValueNodes.Let(slot, value, within(Map.of(variable.getName(), slot), let.getIn()));
  }

  /** Returns the node for the value of a variable. */
  Node variableValue(int slot, Node value) {
    return traced == null ? value : new TracedVariable.Value(slot, value);
  }

  /** Returns the body of a loop with a Boolean condition. */
  Node condition(OCLExpression<EClassifier> loop, Node inner) {
    return traced == null ? inner : new TracedCondition(loop, inner);
  }

  /** Returns the initial value of a variable. */
  Node start(Variable<EClassifier, EParameter> variable) {
    OCLExpression<EClassifier> value = variable.getInitExpression();
    return value == null ? new ValueNodes.Constant(null) : node(value);
  }

  private Node property(PropertyCallExp<EClassifier, EStructuralFeature> call) {
    EStructuralFeature feature = call.getReferredProperty();
    Node source = node(call.getSource());
    Lowered body = lowering.definition(feature);
    if (body != null) {
      return definition(call.getSource().getType(), feature, source, body);
    }
    CollectionKind kind =
        call.getType() instanceof CollectionType<?, ?> type ? type.getKind() : null;
    CollectionKind declared = lowering.model().kindOf(feature);
    boolean ofObject = feature.getEContainingClass() != null && kind == declared;
    if (ofObject && !(feature.getEType() instanceof VoidType<?>) && !isTuple(call.getSource())) {
      return NavigationNodes.Feature.of(source, feature, declared);
    }
    return new NavigationNodes.Part(source, feature, kind, lowering.model());
  }

  private Node definition(
      EClassifier sourceType, EStructuralFeature feature, Node source, Lowered body) {
    List<VirtualCall.Implementation> all = new ArrayList<>(lowering.overrides(sourceType, feature));
    if (all.isEmpty()) {
      return new DefinitionNodes.Call(source, new Node[0], body);
    }
    all.add(new VirtualCall.Implementation((EClass) sourceType, body));
    return new VirtualCall(source, new Node[0], all, (object, values) -> Values.INVALID);
  }

  private static boolean isTuple(OCLExpression<EClassifier> expression) {
    return expression.getType() instanceof org.eclipse.ocl.types.TupleType<?, ?>;
  }

  private Node collection(CollectionLiteralExp<EClassifier> literal) {
    List<CollectionLiteralPart<EClassifier>> parts = literal.getPart();
    if (literal.getKind() == CollectionKind.SEQUENCE_LITERAL && literal.isSimpleRange()) {
      CollectionRange<EClassifier> range = (CollectionRange<EClassifier>) parts.get(0);
      return new ValueNodes.SequenceRange(node(range.getFirst()), node(range.getLast()));
    } else if (parts.size() == 1
        && parts.get(0) instanceof CollectionItem<EClassifier> item
        && Asts.isImplicit(literal)) {
      return new ValueNodes.ImplicitSet(node(item.getItem()));
    }
    return new ValueNodes.CollectionLiteral(
        literal.getKind(),
        parts.stream().map(this::part).toArray(ValueNodes.CollectionLiteral.Part[]::new));
  }

  private ValueNodes.CollectionLiteral.Part part(CollectionLiteralPart<EClassifier> part) {
    if (part instanceof CollectionItem<EClassifier> item) {
      return new ValueNodes.Item(node(item.getItem()));
    }
    CollectionRange<EClassifier> range = (CollectionRange<EClassifier>) part;
    return new ValueNodes.Range(node(range.getFirst()), node(range.getLast()));
  }

  private Node tuple(TupleLiteralExp<EClassifier, EStructuralFeature> literal) {
    List<TupleLiteralPart<EClassifier, EStructuralFeature>> parts = literal.getPart();
    EStructuralFeature[] names =
        parts.stream().map(TupleLiteralPart::getAttribute).toArray(EStructuralFeature[]::new);
    Node[] values = new Node[names.length];
    Arrays.setAll(values, i -> node(parts.get(i).getValue()));
    return new ValueNodes.TupleLiteral(lowering.model(), literal.getType(), names, values);
  }
}
