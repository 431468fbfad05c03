package dev.eventchain.xmi;

import java.util.ArrayList;
import java.util.List;
import org.eclipse.emf.ecore.EAttribute;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EDataType;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.EcorePackage;
import org.eclipse.emf.ecore.util.ExtendedMetaData;
import org.eclipse.emf.ecore.util.FeatureMapUtil;
import org.eclipse.emf.ecore.xml.type.XMLTypePackage;

/**
 * What a class demands of its instances.
 *
 * @param required features that must have values
 * @param bounded lists that may have only so many
 * @param values attributes whose types allow some values only, and lists that may hold such
 * @param keyed references whose targets differ in some of their attributes
 * @param maps maps, whose entries differ in their keys
 * @param unique lists that hold each value once
 * @param paired references with an opposite end
 */
record EcorePlan(
    List<EStructuralFeature> required,
    List<EStructuralFeature> bounded,
    List<EAttribute> values,
    List<EReference> keyed,
    List<EReference> maps,
    List<EStructuralFeature> unique,
    List<EReference> paired) {

  private static final String MAP_ENTRY = "java.util.Map$Entry";

  /**
   * The plan of a class. What is derived or has no place of its own is the program's matter, unless
   * its place is in a feature map: of those, EMF checks how many there are, and the map holds them.
   */
  static EcorePlan of(EClass type) {
    EcorePlan plan =
        new EcorePlan(
            new ArrayList<>(),
            new ArrayList<>(),
            new ArrayList<>(),
            new ArrayList<>(),
            new ArrayList<>(),
            new ArrayList<>(),
            new ArrayList<>());
    for (EStructuralFeature feature : type.getEAllStructuralFeatures()) {
      if (!feature.isDerived() && !feature.isVolatile()) {
        plan.add(feature);
      } else if (isMemberOfMap(feature)) {
        plan.addMultiplicity(feature);
      }
    }
    return plan;
  }

  private static boolean isMemberOfMap(EStructuralFeature feature) {
    ExtendedMetaData extended = ExtendedMetaData.INSTANCE;
    return extended.getFeatureKind(feature) == ExtendedMetaData.ELEMENT_FEATURE
        && (extended.getGroup(feature) != null
            || extended.getMixedFeature(feature.getEContainingClass()) != null);
  }

  private void addMultiplicity(EStructuralFeature feature) {
    if (feature.getLowerBound() > 0) {
      required.add(feature);
    }
    if (feature.isMany() && feature.getUpperBound() > 0) {
      bounded.add(feature);
    }
  }

  private void add(EStructuralFeature feature) {
    addMultiplicity(feature);
    if (Faults.holdsEachOnce(feature)) {
      unique.add(feature);
    }
    if (feature instanceof EReference reference) {
      add(reference);
    } else if (isLimited((EDataType) feature.getEType()) || FeatureMapUtil.isFeatureMap(feature)) {
      values.add((EAttribute) feature);
    }
  }

  private void add(EReference reference) {
    if (reference.isMany() && !reference.getEKeys().isEmpty()) {
      keyed.add(reference);
    }
    if (reference.isMany() && isMapEntry(reference.getEReferenceType())) {
      maps.add(reference);
    }
    if (Statements.hasWrittenOpposite(reference)) {
      paired.add(reference);
    }
  }

  static boolean isMapEntry(EClass type) {
    return MAP_ENTRY.equals(type.getInstanceClassName())
        && type.getEStructuralFeature("key") != null;
  }

  /** Whether a data type may allow some values only: facets, or those of XML Schema's types. */
  static boolean isLimited(EDataType type) {
    boolean annotated = type.getEAnnotation(ExtendedMetaData.ANNOTATION_URI) != null;
    return (annotated && type.getEPackage() != EcorePackage.eINSTANCE)
        || type.getEPackage() == XMLTypePackage.eINSTANCE;
  }
}
