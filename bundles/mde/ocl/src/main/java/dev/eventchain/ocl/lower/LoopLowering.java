package dev.eventchain.ocl.lower;

import dev.eventchain.ocl.nodes.LoopNodes;
import dev.eventchain.ocl.nodes.Node;
import dev.eventchain.ocl.values.CollectionOperations;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EParameter;
import org.eclipse.ocl.expressions.CollectionKind;
import org.eclipse.ocl.expressions.IterateExp;
import org.eclipse.ocl.expressions.IteratorExp;
import org.eclipse.ocl.expressions.LoopExp;
import org.eclipse.ocl.expressions.Variable;
import org.eclipse.ocl.types.OrderedSetType;
import org.eclipse.ocl.types.SetType;
import org.eclipse.ocl.util.OCLStandardLibraryUtil;
import org.eclipse.ocl.utilities.PredefinedType;

/** Lowers loops. */
final class LoopLowering {

  /** The loops with Boolean bodies. */
  private static final Set<Integer> QUESTIONS =
      Set.of(
          PredefinedType.FOR_ALL,
          PredefinedType.EXISTS,
          PredefinedType.ONE,
          PredefinedType.ANY,
          PredefinedType.SELECT,
          PredefinedType.REJECT);

  private final BodyLowering body;
  private final Optional<KeyLowering> keys;

  /**
   * Creates the lowering of the loops in a body.
   *
   * @param keys finds the relevant elements; empty to visit all
   */
  LoopLowering(BodyLowering body, Optional<KeyLowering> keys) {
    this.body = body;
    this.keys = keys;
  }

  Node iterator(IteratorExp<EClassifier, EParameter> loop) {
    int code = OCLStandardLibraryUtil.getOperationCode(loop.getName());
    Node source = body.node(loop.getSource());
    Map<String, Integer> variables = variables(loop);
    Node inner = body.within(variables, loop.getBody());
    if (QUESTIONS.contains(code)) {
      inner = body.condition(loop, inner);
    }
    int[] slots = variables.values().stream().mapToInt(slot -> slot).toArray();
    if (slots.length > 1) {
      return new LoopNodes.MultiQuantifier(source, slots, inner, code == PredefinedType.EXISTS);
    }
    Node elements = keys.map(keyed -> keyed.source(loop, code, source, variables)).orElse(source);
    return loop(loop, code, elements, slots[0], inner);
  }

  private Map<String, Integer> variables(LoopExp<EClassifier, EParameter> loop) {
    Map<String, Integer> variables = new LinkedHashMap<>();
    for (Variable<EClassifier, EParameter> variable : loop.getIterator()) {
      variables.put(variable.getName(), body.newSlot());
    }
    return variables;
  }

  private static Node loop(
      IteratorExp<EClassifier, EParameter> loop, int code, Node source, int slot, Node inner) {
    Object type = loop.getSource().getType();
    boolean distinct = type instanceof SetType<?, ?> || type instanceof OrderedSetType<?, ?>;
    CollectionKind selected = CollectionOperations.kindOfSelection(type);
    CollectionKind collected = CollectionOperations.kindOfCollection(type);
    return switch (code) {
      case PredefinedType.FOR_ALL -> new LoopNodes.Quantifier(source, slot, inner, false);
      case PredefinedType.EXISTS -> new LoopNodes.Quantifier(source, slot, inner, true);
      case PredefinedType.ONE -> new LoopNodes.One(source, slot, inner);
      case PredefinedType.ANY -> new LoopNodes.Any(source, slot, inner);
      case PredefinedType.IS_UNIQUE -> new LoopNodes.IsUnique(source, slot, inner);
      case PredefinedType.SELECT -> new LoopNodes.Select(source, slot, inner, selected, true);
      case PredefinedType.REJECT -> new LoopNodes.Select(source, slot, inner, selected, false);
      case PredefinedType.COLLECT -> new LoopNodes.Collect(source, slot, inner, collected, true);
      case PredefinedType.COLLECT_NESTED ->
          new LoopNodes.Collect(source, slot, inner, collected, false);
      case PredefinedType.SORTED_BY -> new LoopNodes.SortedBy(source, slot, inner, distinct);
      case PredefinedType.CLOSURE ->
          new LoopNodes.Closure(
              source, slot, inner, loop.getType() instanceof OrderedSetType<?, ?>);
      default -> throw new IllegalArgumentException(loop.getName());
    };
  }

  Node iterate(IterateExp<EClassifier, EParameter> loop) {
    Node start = body.start(loop.getResult());
    Node source = body.node(loop.getSource());
    Map<String, Integer> variables = variables(loop);
    int slot = variables.get(loop.getIterator().get(0).getName());
    int result = body.newSlot();
    variables.put(loop.getResult().getName(), result);
    Node inner = body.within(variables, loop.getBody());
    return new LoopNodes.Iterate(
        source, slot, result, body.variableValue(result, start), body.variableValue(result, inner));
  }
}
