package dev.eventchain.eclipse.ui.editor.model;

import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.eclipse.emf.ecore.EModelElement;
import org.eclipse.emf.ecore.ENamedElement;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.util.EcoreUtil;

/** Readable names and texts of the metamodel. */
public final class Words {

  private static final Pattern CAPITAL = Pattern.compile("(?<=[a-z])(?=[A-Z0-9])");

  /** Unit in the documentation of the metamodel: {@code ..., in ms.} */
  private static final Pattern UNIT = Pattern.compile("\\bin (ms|s|Hz|MiB)\\b");

  private Words() {}

  /**
   * Returns a name in words: {@code worstCaseExecutionTime} is {@code Worst case execution time}.
   */
  public static String of(ENamedElement element) {
    return switch (element.getName()) {
      case "SoftwareNode" -> "Component";
      case "QosProfile" -> "Quality of service";
      case "nextstep" -> "Next step";
      case "software" -> "Components";
      case "qos" -> "Quality of service";
      case "id" -> "Id";
      case "runId" -> "Run";
      default -> sentence(element.getName());
    };
  }

  private static String sentence(String name) {
    String words = CAPITAL.matcher(name).replaceAll(" ").toLowerCase(Locale.ROOT);
    return words.substring(0, 1).toUpperCase(Locale.ROOT) + words.substring(1);
  }

  /** Returns the name of a feature with the unit of its value, if the metamodel states one. */
  public static String withUnit(EStructuralFeature feature) {
    Matcher unit = UNIT.matcher(documentation(feature));
    return unit.find() ? of(feature) + " [" + unit.group(1) + "]" : of(feature);
  }

  /** Returns the metamodel's documentation of one of its elements; empty if there is none. */
  public static String documentation(EModelElement element) {
    String text = EcoreUtil.getDocumentation(element);
    return text == null ? "" : text;
  }
}
