package dev.eventchain.jsonmodels;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.eclipse.emf.ecore.EAttribute;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.EStructuralFeature;

/** The classes of a metamodel that an instance model can contain, and the features of each. */
final class SchemaClasses {

  private final EClass root;
  private final Set<EStructuralFeature> without;
  private final boolean byId;
  private final ClassIndex index;
  private final List<EClass> all = new ArrayList<>();
  private final Set<EClass> contained = new HashSet<>();

  /**
   * Collects the classes of a root object and of everything that it can contain.
   *
   * @param without the features to leave out
   * @param byId true if objects are contained by id, which excludes those without id
   */
  SchemaClasses(
      Collection<? extends EPackage> metamodels,
      EClass root,
      Set<EStructuralFeature> without,
      boolean byId) {
    this.root = root;
    this.without = without;
    this.byId = byId;
    this.index = new ClassIndex(metamodels);
    metamodels.forEach(this::add);
    Deque<EClass> open = new ArrayDeque<>(List.of(root));
    while (!open.isEmpty()) {
      for (EReference reference : open.remove().getEAllContainments()) {
        if (isWritten(reference)) {
          concrete(reference).stream().filter(contained::add).forEach(open::add);
        }
      }
    }
  }

  private void add(EPackage ePackage) {
    for (EClassifier classifier : ePackage.getEClassifiers()) {
      if (classifier instanceof EClass eClass) {
        all.add(eClass);
      }
    }
    ePackage.getESubpackages().forEach(this::add);
  }

  /** Returns the classes of objects that can be contained, in the order of the metamodel. */
  List<EClass> contained() {
    return all.stream().filter(contained::contains).toList();
  }

  /** Returns the class of the root, and then those of everything that it can contain. */
  List<EClass> used() {
    List<EClass> used = new ArrayList<>(List.of(root));
    contained().stream().filter(eClass -> eClass != root).forEach(used::add);
    return used;
  }

  /** Returns the classes that the targets of a reference can have. */
  List<EClass> targets(EReference reference) {
    return reference.isContainment()
        ? concrete(reference)
        : used().stream()
            .filter(SchemaClasses::hasId)
            .filter(reference.getEReferenceType()::isSuperTypeOf)
            .toList();
  }

  private List<EClass> concrete(EReference reference) {
    return all.stream()
        .filter(eClass -> !eClass.isAbstract() && !eClass.isInterface())
        .filter(reference.getEReferenceType()::isSuperTypeOf)
        .filter(eClass -> !byId || hasId(eClass))
        .toList();
  }

  /** Returns the unique name of the class for the instance modeler. */
  String name(EClass eClass) {
    String name = eClass.getName();
    String inPackage = eClass.getEPackage().getName() + "." + name;
    if (index.find(name).size() == 1 && !name.equals(InstanceObjects.CLASS)) {
      return name;
    }
    return index.find(inPackage).size() == 1
        ? inPackage
        : eClass.getEPackage().getNsURI() + "#//" + name;
  }

  /**
   * Returns the features that an instance model states, except for the id: none that are derived,
   * refer to the container, or have values that cannot be written. Of two opposites, the first in
   * the metamodel is kept.
   */
  List<EStructuralFeature> features(EClass eClass) {
    return eClass.getEAllStructuralFeatures().stream()
        .filter(feature -> !feature.getName().equals(InstanceObjects.ID))
        .filter(this::isWritten)
        .filter(feature -> !(feature instanceof EReference r) || !targets(r).isEmpty())
        .toList();
  }

  /** Returns the attribute that holds the ids of objects; null if ids are no attribute values. */
  static EStructuralFeature key(EClass eClass) {
    return eClass.getEStructuralFeature(InstanceObjects.ID);
  }

  /** Returns whether objects can state ids, which a feature {@code id} of another type prevents. */
  static boolean hasId(EClass eClass) {
    EStructuralFeature key = key(eClass);
    return key == null
        || (key instanceof EAttribute attribute
            && !key.isMany()
            && InstanceObjects.isWritable(key)
            && AttributeValues.jsonType(attribute.getEAttributeType())
                .filter(Set.of("string", "integer")::contains)
                .isPresent());
  }

  private boolean isWritten(EStructuralFeature feature) {
    if (without.contains(feature)
        || feature.getName().equals(InstanceObjects.CLASS)
        || !InstanceObjects.isWritable(feature)
        || feature.isTransient()) {
      return false;
    }
    return feature instanceof EAttribute attribute
        ? AttributeValues.jsonType(attribute.getEAttributeType()).isPresent()
        : !((EReference) feature).isContainer() && !isSecondOfPair((EReference) feature);
  }

  private boolean isSecondOfPair(EReference reference) {
    EReference opposite = reference.getEOpposite();
    return opposite != null
        && !reference.isContainment()
        && position(opposite) < position(reference)
        && isWritten(opposite);
  }

  /** Returns the position in the metamodel, by index, as feature ids are set lazily. */
  private long position(EReference reference) {
    EClass owner = reference.getEContainingClass();
    return (long) all.indexOf(owner) << 32 | owner.getEStructuralFeatures().indexOf(reference);
  }
}
