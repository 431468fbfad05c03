package dev.eventchain.ocl.nodes;

import dev.eventchain.ocl.model.ModelAccess;
import dev.eventchain.ocl.model.TypeTest;
import dev.eventchain.ocl.values.CollectionOperations;
import dev.eventchain.ocl.values.Halted;
import dev.eventchain.ocl.values.Numbers;
import dev.eventchain.ocl.values.Values;
import java.util.Collection;
import java.util.Iterator;
import java.util.List;
import java.util.Set;
import org.eclipse.emf.common.util.AbstractEList;
import org.eclipse.emf.common.util.EList;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.InternalEObject;
import org.eclipse.emf.ecore.impl.BasicEObjectImpl;
import org.eclipse.ocl.expressions.CollectionKind;

/** Access to the model: features, operations, extents and types. */
public final class NavigationNodes {

  private NavigationNodes() {}

  /** The index of a feature in the objects of a class; -1 if they do not have it. */
  private record Place(EClass type, int index) {}

  /** Reads a feature of an object. */
  public abstract static class Feature extends Node {
    private final Node source;
    private final EStructuralFeature feature;

    /** Cache for the latest class; races are harmless, since each place is immutable. */
    private Place latest;

    private Feature(Node source, EStructuralFeature feature) {
      this.source = source;
      this.feature = feature;
    }

    public static Feature of(Node source, EStructuralFeature feature, CollectionKind kind) {
      boolean foreign = Numbers.isForeign(feature.getEType());
      return kind == null
          ? new SingleFeature(source, feature, foreign)
          : new ManyFeature(source, feature, kind, foreign);
    }

    /**
     * Returns the value for an object.
     *
     * @param read true for a caller of {@link #read}
     */
    abstract Object valueOf(Object object, boolean read, Run run);

    final Node source() {
      return source;
    }

    @Override
    final Object evaluate(Frame frame) {
      return valueOf(source.evaluate(frame), false, frame.run);
    }

    @Override
    final Object read(Frame frame) {
      return valueOf(source.evaluate(frame), true, frame.run);
    }

    /** Returns the value of EMF; invalid also if the object has no such feature. */
    final Object get(Object object, Run run) {
      try {
        // Type tests and calls are faster for a class than for an interface.
        if (object instanceof BasicEObjectImpl usual) {
          int index = indexIn(usual.eClass());
          return index < 0 ? INVALID : usual.eGet(index, true, true);
        } else if (object instanceof InternalEObject other) {
          int index = indexIn(other.eClass());
          return index < 0 ? INVALID : other.eGet(index, true, true);
        }
        return INVALID;
      } catch (Halted e) {
        throw e;
      } catch (RuntimeException e) {
        run.fail(e);
        return INVALID;
      }
    }

    private int indexIn(EClass type) {
      Place place = latest;
      if (place == null || place.type() != type) {
        place = new Place(type, type.getFeatureID(feature));
        latest = place;
      }
      return place.index();
    }
  }

  private static final class SingleFeature extends Feature {
    private final boolean foreign;

    /** True if values need no conversion: single ones in OCL's representation. */
    private final boolean plain;

    SingleFeature(Node source, EStructuralFeature feature, boolean foreign) {
      super(source, feature);
      this.foreign = foreign;
      this.plain = !foreign && !feature.isMany();
    }

    @Override
    Object valueOf(Object object, boolean read, Run run) {
      Object value = get(object, run);
      if (plain) {
        return value;
      }
      if (Values.isCollection(value) && !(value instanceof Iterator<?>)) {
        value = first((Collection<?>) value);
      }
      return foreign ? Numbers.normal(value) : value;
    }

    private static Object first(Collection<?> several) {
      return several.isEmpty() ? null : several.iterator().next();
    }
  }

  private static final class ManyFeature extends Feature {
    private final CollectionKind kind;
    private final boolean foreign;

    /** True if a caller of {@link #read} can get the model's own list. */
    private final boolean direct;

    ManyFeature(Node source, EStructuralFeature feature, CollectionKind kind, boolean foreign) {
      super(source, feature);
      this.kind = kind;
      this.foreign = foreign;
      boolean distinct =
          kind == CollectionKind.SET_LITERAL || kind == CollectionKind.ORDERED_SET_LITERAL;
      // A list of EMF may hold both 0.0 and -0.0.
      this.direct = !foreign && !(distinct && Numbers.isDouble(feature.getEType()));
    }

    @Override
    CollectionKind kindOfElements() {
      return kind;
    }

    private Object collect(Object value) {
      if (value == INVALID) {
        return value;
      }
      return CollectionOperations.asCollection(kind, foreign ? Values.normal(value) : value);
    }

    /** Uses that EMF's lists of a unique feature contain no element twice. */
    @Override
    Object valueOf(Object object, boolean read, Run run) {
      Object value = get(object, run);
      if (!read || !direct) {
        return collect(value);
      }
      return value instanceof AbstractEList<?> || value instanceof EList<?>
          ? value
          : collect(value);
    }
  }

  /** Reads a part of a tuple, or another rare property. */
  public static final class Part extends GuardedNode {
    private final Node source;
    private final EStructuralFeature property;
    private final CollectionKind kind;
    private final ModelAccess environment;

    public Part(
        Node source, EStructuralFeature property, CollectionKind kind, ModelAccess environment) {
      this.source = source;
      this.property = property;
      this.kind = kind;
      this.environment = environment;
    }

    @Override
    Object compute(Frame frame) {
      Object tuple = source.evaluate(frame);
      if (isUndefined(tuple)) {
        return INVALID;
      }
      Object value = environment.navigateProperty(property, List.of(), tuple);
      if (kind == null || isUndefined(value) || value instanceof Collection<?>) {
        return value;
      }
      Collection<Object> single = CollectionOperations.create(kind);
      single.add(value);
      return single;
    }
  }

  /** Calls an operation that Java code implements. */
  public static final class Operation extends GuardedNode {
    private final EOperation operation;
    private final int code;
    private final Node source;
    private final Node[] arguments;
    private final ModelAccess environment;

    public Operation(
        EOperation operation, int code, Node source, Node[] arguments, ModelAccess environment) {
      this.operation = operation;
      this.code = code;
      this.source = source;
      this.arguments = arguments;
      this.environment = environment;
    }

    /** Passes on all messages of foreign code. */
    @Override
    boolean tells(RuntimeException e) {
      return true;
    }

    @Override
    Object compute(Frame frame) {
      Object object = source.evaluate(frame);
      Object[] values = DefinitionNodes.evaluate(arguments, frame);
      return environment.callOperation(operation, code, object, values);
    }
  }

  /** {@code allInstances()} of a class. */
  public static final class AllInstances extends Node {
    private final EClass type;

    public AllInstances(EClass type) {
      this.type = type;
    }

    @Override
    Object evaluate(Frame frame) {
      Set<EObject> extent = frame.run.allInstances(type);
      return extent;
    }
  }

  /** {@code oclIsKindOf} and {@code oclIsTypeOf}, which have no value for an undefined source. */
  public static final class IsOfType extends GuardedNode {
    private final Node source;
    private final TypeTest test;

    public IsOfType(Node source, TypeTest test) {
      this.source = source;
      this.test = test;
    }

    @Override
    Object compute(Frame frame) {
      Object value = source.evaluate(frame);
      return isUndefined(value) ? INVALID : (Object) test.holds(value);
    }
  }

  /** {@code oclAsType} of an object; that of null is null, as in Eclipse OCL. */
  public static final class AsType extends GuardedNode {
    private final Node source;
    private final TypeTest test;

    public AsType(Node source, EClassifier type, ModelAccess environment) {
      this.source = source;
      this.test = new TypeTest(type, false, environment);
    }

    @Override
    Object compute(Frame frame) {
      Object value = source.evaluate(frame);
      return value == null || (value != INVALID && test.holds(value)) ? value : INVALID;
    }
  }

  /** A value that is computed from a variable, and null where the variable is. */
  public static final class UnlessNull extends Node {
    private final int slot;
    private final Node inner;

    public UnlessNull(int slot, Node inner) {
      this.slot = slot;
      this.inner = inner;
    }

    @Override
    Object evaluate(Frame frame) {
      return frame.slots[slot] == null ? null : inner.evaluate(frame);
    }
  }

  /** The elements of a collection that are not null. */
  public static final class WithoutNull extends Node {
    private final Node source;

    public WithoutNull(Node source) {
      this.source = source;
    }

    @Override
    Object evaluate(Frame frame) {
      Object value = source.evaluate(frame);
      // The same collection, if it can be, since an index of its elements belongs to it.
      return Values.isCollection(value) && hasNull((Collection<?>) value)
          ? CollectionOperations.excluding((Collection<?>) value, null)
          : value;
    }

    private static boolean hasNull(Collection<?> elements) {
      for (Object element : elements) {
        if (element == null) {
          return true;
        }
      }
      return false;
    }
  }
}
