package dev.eventchain.eclipse.ui.editor;

import dev.eventchain.eclipse.ui.editor.field.FieldContext;
import dev.eventchain.eclipse.ui.editor.model.Completions;
import dev.eventchain.eclipse.ui.editor.model.EditedModel;
import dev.eventchain.eclipse.ui.editor.model.Labels;
import dev.eventchain.eclipse.ui.editor.model.ModelFile;
import dev.eventchain.eclipse.ui.editor.tree.ChainTree;
import dev.eventchain.eclipse.ui.editor.tree.TreeActions;
import dev.eventchain.eclipse.ui.editor.validation.EditorValidation;
import dev.eventchain.eclipse.ui.editor.validation.ElementFinding;
import dev.eventchain.eclipse.ui.editor.validation.FolderValidation;
import dev.eventchain.eclipse.ui.editor.validation.ProjectMessages;
import dev.eventchain.model.eventchain.EventChain;
import java.util.ArrayList;
import java.util.EventObject;
import java.util.List;
import org.eclipse.emf.common.command.CommandStackListener;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.jface.action.MenuManager;
import org.eclipse.jface.dialogs.IMessageProvider;
import org.eclipse.jface.layout.GridDataFactory;
import org.eclipse.jface.layout.GridLayoutFactory;
import org.eclipse.jface.viewers.IStructuredSelection;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.SashForm;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Menu;
import org.eclipse.ui.IEditorSite;
import org.eclipse.ui.forms.IMessageManager;
import org.eclipse.ui.forms.ManagedForm;
import org.eclipse.ui.forms.widgets.FormToolkit;
import org.eclipse.ui.forms.widgets.ScrolledForm;
import org.eclipse.ui.handlers.IHandlerService;

/** The page of an editor for a chain: tree, properties and findings. */
final class ModelPage {

  /** Menu of the tree, for contributions of other bundles. */
  private static final String MENU = "dev.eventchain.eclipse.ui.editor.tree";

  private final EditedModel model;
  private final Composite area;
  private final ManagedForm managed;
  private final ShownFindings findings = new ShownFindings();
  private final ChainTree tree;
  private final PropertyForm properties;
  private final TreeActions actions;
  private final EditorValidation validation;
  private final RulesWatch rules;
  private final ChainSelection selection;
  private final List<Runnable> changed = new ArrayList<>();
  private String about = "";
  private boolean isChecked;
  private final CommandStackListener listener = this::stackChanged;

  ModelPage(
      Composite parent,
      EditedModel model,
      IEditorSite site,
      ChainSelection selection,
      ModelFile file) {
    this.model = model;
    this.selection = selection;
    area = new Composite(parent, SWT.NONE);
    managed = form(area);
    ScrolledForm form = managed.getForm();
    FormToolkit toolkit = managed.getToolkit();
    ProjectMessages messages = new ProjectMessages(file::file);
    SashForm sash = new SashForm(form.getBody(), SWT.HORIZONTAL);
    toolkit.adapt(sash);
    GridLayoutFactory.swtDefaults().margins(4, 4).applyTo(form.getBody());
    GridDataFactory.fillDefaults().grab(true, true).hint(200, 100).applyTo(sash);
    tree = new ChainTree(sash, findings);
    FieldContext context =
        new FieldContext(toolkit, model, new Completions(messages), this::select, this::decorate);
    properties = new PropertyForm(sash, context);
    sash.setWeights(2, 3);
    actions = new TreeActions(model, tree);
    actions.fill(form.getToolBarManager());
    actions.handleIn(site.getService(IHandlerService.class));
    addMenu(site);
    validation =
        new EditorValidation(
            new FolderValidation(messages), model.chain(), file::file, this::found);
    rules = new RulesWatch(file::file, this::recheck);
    FindingsMenu.open(form.getForm(), findings, this::select);
    area.addDisposeListener(event -> dispose());
    start();
  }

  private static ManagedForm form(Composite area) {
    GridLayoutFactory.fillDefaults().applyTo(area);
    FormToolkit toolkit = new FormToolkit(area.getDisplay());
    ScrolledForm form = toolkit.createScrolledForm(area);
    GridDataFactory.fillDefaults().grab(true, true).applyTo(form);
    toolkit.decorateFormHeading(form.getForm());
    return new ManagedForm(toolkit, form);
  }

  private void start() {
    tree.viewer().addSelectionChangedListener(event -> selected(event.getStructuredSelection()));
    tree.show(model.chain());
    tree.select(model.chain());
    model.stack().addCommandStackListener(listener);
    showTitle();
    validation.schedule();
  }

  private void addMenu(IEditorSite site) {
    MenuManager manager = new MenuManager();
    manager.setRemoveAllWhenShown(true);
    manager.addMenuListener(actions::fill);
    Menu menu = manager.createContextMenu(tree.viewer().getControl());
    tree.viewer().getControl().setMenu(menu);
    site.registerContextMenu(MENU, manager, selection, false);
  }

  private void dispose() {
    model.stack().removeCommandStackListener(listener);
    validation.dispose();
    rules.dispose();
    managed.dispose();
  }

  EditedModel model() {
    return model;
  }

  EventChain chain() {
    return model.chain();
  }

  ShownFindings findings() {
    return findings;
  }

  /** Rechecks the chain because its rules may have changed; until then its findings are unknown. */
  void recheck() {
    if (!area.isDisposed()) {
      isChecked = false;
      decorate();
      validation.schedule();
    }
  }

  /** Adds a listener for changes of the model or its findings. */
  void whenChanged(Runnable work) {
    changed.add(work);
  }

  /** Shows a message about the file in the heading; an empty text removes it. */
  void say(String text) {
    about = text;
    decorate();
  }

  void setFocus() {
    if (tree.viewer().getControl().setFocus()) {
      actions.focusGained();
    }
  }

  /** Shows an element in the tree. */
  void select(EObject element) {
    tree.select(element);
  }

  private void selected(IStructuredSelection shown) {
    managed.getMessageManager().removeAllMessages(); // those of controls that are disposed now
    properties.show(shown.size() == 1 ? shown.getFirstElement() : null);
    decorate();
    selection.changed(shown);
  }

  private void stackChanged(EventObject event) {
    if (!area.isDisposed()) {
      isChecked = false; // unknown until it is checked again
      decorate();
      tree.viewer().refresh();
      properties.refresh();
      actions.update();
      showTitle();
      validation.schedule();
      changed.forEach(Runnable::run);
    }
  }

  private void showTitle() {
    managed.getForm().setText(Labels.of(model.chain()).name());
  }

  private void found(List<ElementFinding> found) {
    if (!area.isDisposed()) {
      isChecked = true;
      findings.set(model.chain(), found);
      tree.viewer().refresh(true);
      decorate();
      changed.forEach(Runnable::run);
    }
  }

  private void decorate() {
    IMessageManager messages = managed.getMessageManager();
    messages.setAutoUpdate(false);
    messages.removeAllMessages();
    if (!about.isEmpty()) {
      messages.addMessage(this, about, null, IMessageProvider.WARNING);
    }
    List<ElementFinding> placed = properties.decorate(messages, findings.all());
    for (ElementFinding finding : findings.all()) {
      if (!placed.contains(finding)) {
        String text = Labels.of(finding.element()).name() + ": " + finding.text();
        int type = PropertyForm.type(finding.severity());
        messages.addMessage(finding, text, finding.element(), type);
      }
    }
    if (isChecked && findings.all().isEmpty() && about.isEmpty()) {
      messages.addMessage(findings, "Checked: no problems found", null, IMessageProvider.NONE);
    }
    messages.setAutoUpdate(true);
  }
}
