package dev.eventchain.ocl.editing;

import dev.eventchain.ocl.metamodel.Names;
import java.util.List;
import java.util.stream.Collectors;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EEnum;
import org.eclipse.emf.ecore.EEnumLiteral;
import org.eclipse.emf.ecore.EModelElement;
import org.eclipse.emf.ecore.ENamedElement;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.EParameter;
import org.eclipse.emf.ecore.ETypedElement;
import org.eclipse.emf.ecore.util.EcoreUtil;

/** Descriptions of elements of a metamodel and of names, in Markdown. */
public final class Descriptions {

  /** The end of the name of a class in which Eclipse OCL keeps what a class has in OCL only. */
  private static final String KEEPER = "_Class";

  private Descriptions() {}

  /** Returns the documentation of an element of a metamodel; empty if there is none. */
  public static String documentation(Object element) {
    String text =
        element instanceof EModelElement documented ? EcoreUtil.getDocumentation(documented) : null;
    return text == null ? "" : text.strip();
  }

  /** Returns the text about a name. */
  public static String of(Mention mention) {
    String documentation = documentation(mention.target());
    return code(headOf(mention)) + (documentation.isEmpty() ? "" : "\n\n" + documentation);
  }

  /** Returns a text as a block of code. */
  public static String code(String text) {
    return "```ocl\n" + text + "\n```";
  }

  private static String headOf(Mention mention) {
    return switch (mention.kind()) {
      case VARIABLE, DECLARATION -> typed(mention.name(), Members.name(mention.type()));
      case FEATURE, OPERATION ->
          mention.target() instanceof ETypedElement element
              ? head(element, mention)
              : typed(mention.name(), Members.name(mention.type()));
      case ITERATOR ->
          typed(
              Members.name(mention.owner()) + "->" + mention.name() + "(...)",
              Members.name(mention.type()));
      case LIBRARY_OPERATION -> typed(mention.name() + "(...)", Members.name(mention.type()));
      case TYPE -> mention.type() == null ? mention.name() : classifier(mention.type());
      case LITERAL ->
          mention.target() instanceof EEnumLiteral literal
              ? Names.qualified(literal.getEEnum())
                  + "::"
                  + literal.getName()
                  + " = "
                  + literal.getValue()
              : mention.name();
    };
  }

  private static String typed(String name, String type) {
    return type.isEmpty() ? name : name + " : " + type;
  }

  private static String head(ETypedElement element, Mention mention) {
    String owner = ownerOf(element, mention);
    String name = owner.isEmpty() ? element.getName() : owner + "::" + element.getName();
    String parameters =
        element instanceof EOperation operation ? "(" + parameters(operation) + ")" : "";
    String bounds =
        element.getUpperBound() == 1 && !(element instanceof EOperation)
            ? element.getLowerBound() == 0 ? " [0..1]" : " [1]"
            : "";
    return typed(name + parameters, Members.name(mention.type())) + bounds;
  }

  /** Returns the name of the class that has an element, also if Eclipse OCL keeps it for that. */
  private static String ownerOf(ETypedElement element, Mention mention) {
    String name = element.eContainer() instanceof ENamedElement named ? named.getName() : null;
    if (name == null) {
      return "";
    }
    boolean kept =
        mention.owner() != null
            && name.endsWith(KEEPER)
            && !(mention.owner() instanceof EClass owner
                && (owner == element.eContainer()
                    || owner.getEAllSuperTypes().contains(element.eContainer())));
    return kept ? name.substring(0, name.length() - KEEPER.length()) : name;
  }

  private static String parameters(EOperation operation) {
    return operation.getEParameters().stream()
        .map(Descriptions::parameter)
        .collect(Collectors.joining(", "));
  }

  private static String parameter(EParameter parameter) {
    String name = parameter.getName() == null ? "" : parameter.getName();
    String type = Members.name(parameter.getEType());
    return name.isEmpty() ? type : typed(name, type);
  }

  private static String classifier(EClassifier type) {
    if (type instanceof EEnum enumeration) {
      List<String> literals =
          enumeration.getELiterals().stream().map(ENamedElement::getName).toList();
      return "enum " + Names.qualified(type) + " { " + String.join(", ", literals) + " }";
    } else if (type instanceof EClass owner && type.getEPackage() != null) {
      List<String> supers = owner.getESuperTypes().stream().map(ENamedElement::getName).toList();
      return (owner.isAbstract() ? "abstract class " : "class ")
          + Names.qualified(type)
          + (supers.isEmpty() ? "" : " extends " + String.join(", ", supers));
    }
    return type.getEPackage() == null ? Members.name(type) : "type " + Names.qualified(type);
  }
}
