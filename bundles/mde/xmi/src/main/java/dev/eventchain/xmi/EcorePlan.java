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
 * The checks that a class requires for its instances.
 *
 * @param required the features that must have values
 * @param bounded the lists with an upper or lower bound
 * @param values the attributes of restricted types, and feature maps that may hold such
 * @param keyed the references whose targets must differ in key attributes
 * @param maps the maps, whose entries must differ in their keys
 * @param unique the lists without duplicates
 * @param paired the references with an opposite
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
   * Returns the plan of a class. Derived features and those without storage are left to the
   * program, except for those stored in a feature map, whose multiplicity EMF checks.
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

  /** Returns whether a data type may restrict its values, by facets or as a type of XML Schema. */
  static boolean isLimited(EDataType type) {
    boolean annotated = type.getEAnnotation(ExtendedMetaData.ANNOTATION_URI) != null;
    return (annotated && type.getEPackage() != EcorePackage.eINSTANCE)
        || type.getEPackage() == XMLTypePackage.eINSTANCE;
  }
}
