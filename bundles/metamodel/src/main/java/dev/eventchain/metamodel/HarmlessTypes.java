package dev.eventchain.metamodel;

import java.util.HashSet;
import java.util.Set;
import org.eclipse.emf.ecore.EDataType;
import org.eclipse.emf.ecore.EEnum;
import org.eclipse.emf.ecore.EcorePackage;
import org.eclipse.emf.ecore.util.ExtendedMetaData;
import org.eclipse.emf.ecore.xml.type.XMLTypePackage;

/**
 * Which data types make their values from text without running foreign code. EMF calls the
 * constructor or {@code valueOf} of the Java class that a metamodel names, deserialises Java
 * objects for {@code EJavaObject}, and loads classes for {@code EJavaClass}: a file must not reach
 * those.
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

  /** Whether text of a file may become a value of a type. */
  static boolean contains(EDataType type) {
    return contains(type, new HashSet<>());
  }

  private static boolean contains(EDataType type, Set<EDataType> seen) {
    if (type == EcorePackage.Literals.EJAVA_OBJECT || type == EcorePackage.Literals.EJAVA_CLASS) {
      return false;
    }
    boolean known =
        type.getEPackage() == EcorePackage.eINSTANCE
            || type instanceof EEnum
            || type.getInstanceClassName() == null
            || JAVA_CLASSES.contains(type.getInstanceClassName());
    return known && (!seen.add(type) || hasHarmlessParts(type, seen));
  }

  /** XML Schema's derived types hand the text on to the types that they are made of. */
  private static boolean hasHarmlessParts(EDataType type, Set<EDataType> seen) {
    if (type.getEAnnotation(ExtendedMetaData.ANNOTATION_URI) == null) {
      return true;
    }
    EDataType base = ExtendedMetaData.INSTANCE.getBaseType(type);
    EDataType item = ExtendedMetaData.INSTANCE.getItemType(type);
    return (base == null || isHarmlessPart(base, seen))
        && (item == null || isHarmlessPart(item, seen))
        && ExtendedMetaData.INSTANCE.getMemberTypes(type).stream()
            .allMatch(member -> isHarmlessPart(member, seen));
  }

  private static boolean isHarmlessPart(EDataType type, Set<EDataType> seen) {
    return type.getEPackage() == XMLTypePackage.eINSTANCE || contains(type, seen);
  }
}
