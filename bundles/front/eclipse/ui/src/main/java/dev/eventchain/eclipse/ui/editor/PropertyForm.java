package dev.eventchain.eclipse.ui.editor;

import dev.eventchain.diagnostics.Severity;
import dev.eventchain.eclipse.ui.editor.field.BooleanField;
import dev.eventchain.eclipse.ui.editor.field.EnumField;
import dev.eventchain.eclipse.ui.editor.field.Field;
import dev.eventchain.eclipse.ui.editor.field.FieldContext;
import dev.eventchain.eclipse.ui.editor.field.NumberField;
import dev.eventchain.eclipse.ui.editor.field.ReadOnlyField;
import dev.eventchain.eclipse.ui.editor.field.ReferenceField;
import dev.eventchain.eclipse.ui.editor.field.ReferencesField;
import dev.eventchain.eclipse.ui.editor.field.TextField;
import dev.eventchain.eclipse.ui.editor.model.Group;
import dev.eventchain.eclipse.ui.editor.model.Labels;
import dev.eventchain.eclipse.ui.editor.model.Words;
import dev.eventchain.eclipse.ui.editor.validation.ElementFinding;
import dev.eventchain.model.eventchain.ChainMeasurement;
import dev.eventchain.model.eventchain.NodeMeasurement;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.eclipse.emf.ecore.EAttribute;
import org.eclipse.emf.ecore.EEnum;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.EcorePackage;
import org.eclipse.jface.dialogs.IMessageProvider;
import org.eclipse.jface.layout.GridDataFactory;
import org.eclipse.jface.layout.GridLayoutFactory;
import org.eclipse.jface.resource.JFaceResources;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Label;
import org.eclipse.ui.forms.IMessageManager;
import org.eclipse.ui.forms.widgets.ScrolledForm;

/** The properties of the selection, generated from the metamodel. */
final class PropertyForm {

  private final FieldContext context;
  private final ScrolledForm form;
  private final Map<Field, Control> fields = new LinkedHashMap<>();
  private Object shown;

  PropertyForm(Composite parent, FieldContext context) {
    this.context = context;
    form = context.toolkit().createScrolledForm(parent);
    GridLayoutFactory.swtDefaults()
        .numColumns(2)
        .margins(10, 8)
        .spacing(14, 6)
        .applyTo(form.getBody());
  }

  /** Shows an element or a heading; null for nothing. */
  void show(Object element) {
    if (element == shown) {
      return;
    }
    shown = element;
    context.model().stack().endTyping();
    form.setRedraw(false);
    fields.clear();
    for (Control child : form.getBody().getChildren()) {
      child.dispose();
    }
    if (element instanceof EObject object) {
      describe(Words.of(object.eClass()), Words.documentation(object.eClass()));
      object.eClass().getEAllStructuralFeatures().forEach(feature -> add(object, feature));
    } else if (element instanceof Group group) {
      describe(Labels.of(group).name(), Words.documentation(group.feature()));
    }
    refresh();
    form.reflow(true);
    form.setOrigin(0, 0);
    form.setRedraw(true);
  }

  private void describe(String title, String text) {
    Label heading = context.toolkit().createLabel(form.getBody(), title);
    heading.setFont(JFaceResources.getBannerFont());
    GridDataFactory.fillDefaults().span(2, 1).applyTo(heading);
    Label line = context.toolkit().createLabel(form.getBody(), text, SWT.WRAP);
    GridDataFactory.fillDefaults()
        .span(2, 1)
        .grab(true, false)
        .hint(100, SWT.DEFAULT)
        .applyTo(line);
  }

  private void add(EObject element, EStructuralFeature feature) {
    if (feature instanceof EReference reference && reference.isContainment()) {
      return; // the tree shows it
    }
    Field field = field(element, feature);
    Label label = context.toolkit().createLabel(form.getBody(), Words.withUnit(feature));
    label.setToolTipText(Words.documentation(feature));
    boolean isHigh = feature.isMany() || feature.getName().equals("description");
    GridDataFactory.swtDefaults()
        .align(SWT.BEGINNING, isHigh ? SWT.BEGINNING : SWT.CENTER)
        .applyTo(label);
    Control control = field.create(form.getBody());
    control.setToolTipText(Words.documentation(feature));
    control.setData(Field.FEATURE, feature.getName());
    fields.put(field, control);
  }

  private Field field(EObject element, EStructuralFeature feature) {
    if (isMeasured(element)) {
      return new ReadOnlyField(context, element, feature);
    } else if (feature instanceof EReference reference) {
      return reference.isMany()
          ? new ReferencesField(context, element, reference)
          : new ReferenceField(context, element, reference);
    } else if (feature.getEType() instanceof EEnum) {
      return new EnumField(context, element, feature);
    } else if (feature.getEType() == EcorePackage.Literals.EBOOLEAN) {
      return new BooleanField(context, element, feature);
    } else if (((EAttribute) feature).getEAttributeType() == EcorePackage.Literals.ESTRING) {
      boolean isLong = List.of("description", "text").contains(feature.getName());
      return new TextField(context, element, feature, isLong);
    }
    return new NumberField(context, element, feature);
  }

  private static boolean isMeasured(EObject element) {
    for (EObject up = element; up != null; up = up.eContainer()) {
      if (up instanceof NodeMeasurement || up instanceof ChainMeasurement) {
        return true;
      }
    }
    return false;
  }

  /** Refreshes after a change of the model. */
  void refresh() {
    fields.keySet().forEach(Field::refresh);
  }

  /**
   * Shows the findings about the element at its fields.
   *
   * @return the findings that are shown
   */
  List<ElementFinding> decorate(IMessageManager messages, List<ElementFinding> findings) {
    List<ElementFinding> placed = new ArrayList<>();
    fields.forEach(
        (field, control) -> {
          messages.removeMessages(control);
          if (!field.problem().isEmpty()) {
            messages.addMessage(field, field.problem(), null, IMessageProvider.ERROR, control);
          }
          for (ElementFinding finding : findings) {
            if (isAbout(finding, field)) {
              int type = type(finding.severity());
              messages.addMessage(finding, finding.text(), finding.element(), type, control);
              placed.add(finding);
            }
          }
        });
    return placed;
  }

  /**
   * Returns whether a finding is about a field: constraints mostly name the feature only in their
   * text.
   */
  private static boolean isAbout(ElementFinding finding, Field field) {
    if (finding.element() != field.element()) {
      return false;
    }
    return finding.feature() == null
        ? field.feature() == mentioned(finding)
        : finding.feature() == field.feature();
  }

  private static EStructuralFeature mentioned(ElementFinding finding) {
    String text = finding.text();
    return finding.element().eClass().getEAllStructuralFeatures().stream()
        .filter(feature -> text.matches("(?s).*\\b" + feature.getName() + "\\b.*"))
        .findFirst()
        .orElse(null);
  }

  static int type(Severity severity) {
    return switch (severity) {
      case ERROR -> IMessageProvider.ERROR;
      case WARNING -> IMessageProvider.WARNING;
      case INFO -> IMessageProvider.INFORMATION;
    };
  }
}
