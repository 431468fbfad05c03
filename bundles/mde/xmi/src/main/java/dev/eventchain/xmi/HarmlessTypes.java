package dev.eventchain.xmi;

import dev.eventchain.uml.Uml;
import java.util.HashSet;
import java.util.Set;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EDataType;
import org.eclipse.emf.ecore.EEnum;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EcorePackage;
import org.eclipse.emf.ecore.util.ExtendedMetaData;
import org.eclipse.emf.ecore.xml.namespace.XMLNamespacePackage;
import org.eclipse.emf.ecore.xml.type.XMLTypePackage;

/**
 * Decides which data types create their values from text without running foreign code. EMF calls
 * the constructor or {@code valueOf} of the Java class that a metamodel names, deserialises Java
 * objects for {@code EJavaObject}, and loads classes for {@code EJavaClass}: files must not trigger
 * these.
 */
final class HarmlessTypes {

  private static final Set<String> JAVA_CLASSES =
      Set.of(
          "boolean",
          "byte",
          "byte[]",
          "char",
          "double",
          "float",
          "int",
          "long",
          "short",
          "java.lang.Boolean",
          "java.lang.Byte",
          "java.lang.Character",
          "java.lang.Double",
          "java.lang.Float",
          "java.lang.Integer",
          "java.lang.Long",
          "java.lang.Short",
          "java.lang.String",
          "java.math.BigDecimal",
          "java.math.BigInteger",
          "java.util.Date",
          "java.util.UUID");

  private HarmlessTypes() {}

  /** Returns whether the Java class that a data type names itself is harmless. */
  static boolean isHarmlessClass(EClassifier type) {
    String name = type.getInstanceClassName();
    return name == null || JAVA_CLASSES.contains(name);
  }

  /** Returns whether text of a file may become a value of a type. */
  static boolean contains(EDataType type) {
    return contains(type, new HashSet<>());
  }

  private static boolean contains(EDataType type, Set<EDataType> seen) {
    if (type == EcorePackage.Literals.EJAVA_OBJECT || type == EcorePackage.Literals.EJAVA_CLASS) {
      return false;
    }
    boolean known = isBuiltIn(type.getEPackage()) || type instanceof EEnum || isHarmlessClass(type);
    return known && (!seen.add(type) || hasHarmlessParts(type, seen));
  }

  /** Checks the base, item and member types, to which XML Schema's derived types pass the text. */
  private static boolean hasHarmlessParts(EDataType type, Set<EDataType> seen) {
    if (type.getEAnnotation(ExtendedMetaData.ANNOTATION_URI) == null) {
      return true;
    }
    EDataType base = ExtendedMetaData.INSTANCE.getBaseType(type);
    EDataType item = ExtendedMetaData.INSTANCE.getItemType(type);
    return (base == null || contains(base, seen))
        && (item == null || contains(item, seen))
        && ExtendedMetaData.INSTANCE.getMemberTypes(type).stream()
            .allMatch(member -> contains(member, seen));
  }

  /** Returns whether EMF's own code creates the values of a package's types. */
  private static boolean isBuiltIn(EPackage ePackage) {
    return ePackage == EcorePackage.eINSTANCE
        || ePackage == XMLTypePackage.eINSTANCE
        || ePackage == XMLNamespacePackage.eINSTANCE
        || Uml.isMetamodel(ePackage);
  }
}
