package dev.eventchain.eclipse.ui.editor.tree;

import dev.eventchain.eclipse.ui.editor.model.Clip;
import dev.eventchain.eclipse.ui.editor.model.EditedModel;
import dev.eventchain.eclipse.ui.editor.model.Icon;
import dev.eventchain.eclipse.ui.editor.model.Structure;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.eclipse.jface.action.Action;
import org.eclipse.jface.action.IAction;
import org.eclipse.jface.action.IMenuManager;
import org.eclipse.jface.action.IToolBarManager;
import org.eclipse.jface.action.MenuManager;
import org.eclipse.jface.action.Separator;
import org.eclipse.jface.commands.ActionHandler;
import org.eclipse.jface.resource.ImageDescriptor;
import org.eclipse.jface.viewers.StructuredSelection;
import org.eclipse.swt.SWT;
import org.eclipse.ui.ISharedImages;
import org.eclipse.ui.IWorkbenchCommandConstants;
import org.eclipse.ui.PlatformUI;
import org.eclipse.ui.handlers.IHandlerActivation;
import org.eclipse.ui.handlers.IHandlerService;

/** Actions on the selected elements of the tree: in the menu, the tool bar and by keys. */
public final class TreeActions {

  private final EditedModel model;
  private final Structure structure;
  private final ChainTree tree;
  private final Map<String, IAction> commands = new LinkedHashMap<>();
  private final List<Step> steps = new ArrayList<>();
  private final List<IHandlerActivation> active = new ArrayList<>();
  private IHandlerService service;
  private final Step delete = step("Delete", this::delete, this::canDelete);
  private final Step duplicate = step("Duplicate", this::duplicate, this::canDelete);
  private final Step up = step("Move Up", () -> move(-1), () -> canMove(-1));
  private final Step down = step("Move Down", () -> move(1), () -> canMove(1));
  private final Step cut = step("Cut", this::cut, this::canDelete);
  private final Step copy = step("Copy", () -> Clip.copy(tree().elements()), this::canDelete);
  private final Step paste = step("Paste", this::paste, () -> Clip.fits(target()));

  public TreeActions(EditedModel model, ChainTree tree) {
    this.model = model;
    this.structure = new Structure(model);
    TreeDrag.enable(tree, structure);
    this.tree = tree;
    ISharedImages images = PlatformUI.getWorkbench().getSharedImages();
    delete.show(images, ISharedImages.IMG_TOOL_DELETE);
    cut.show(images, ISharedImages.IMG_TOOL_CUT);
    copy.show(images, ISharedImages.IMG_TOOL_COPY);
    paste.show(images, ISharedImages.IMG_TOOL_PASTE);
    up.setImageDescriptor(Icon.UP.descriptor());
    down.setImageDescriptor(Icon.DOWN.descriptor());
    commands.put(IWorkbenchCommandConstants.EDIT_DELETE, delete);
    commands.put(IWorkbenchCommandConstants.EDIT_CUT, cut);
    commands.put(IWorkbenchCommandConstants.EDIT_COPY, copy);
    commands.put(IWorkbenchCommandConstants.EDIT_PASTE, paste);
    commands.forEach((id, action) -> action.setActionDefinitionId(id));
    tree.viewer().addSelectionChangedListener(event -> update());
    update();
  }

  private ChainTree tree() {
    return tree;
  }

  private static final class Step extends Action {

    private final Runnable work;
    private final BooleanSupplier isPossible;

    private Step(String text, Runnable work, BooleanSupplier isPossible) {
      super(text);
      this.work = work;
      this.isPossible = isPossible;
    }

    private void show(ISharedImages images, String name) {
      setImageDescriptor(images.getImageDescriptor(name));
    }

    @Override
    public void run() {
      if (isPossible.getAsBoolean()) {
        work.run();
      }
    }
  }

  private Step step(String text, Runnable work, BooleanSupplier isPossible) {
    Step step = new Step(text, work, isPossible);
    steps.add(step);
    return step;
  }

  /** Updates the enabled state of the actions. */
  public void update() {
    steps.forEach(step -> step.setEnabled(step.isPossible.getAsBoolean()));
  }

  /** Activates the keys for cut, copy, paste and delete while the tree has the focus. */
  public void handleIn(IHandlerService handlers) {
    service = handlers;
    tree.viewer().getTree().addListener(SWT.FocusIn, event -> focusGained());
    tree.viewer().getTree().addListener(SWT.FocusOut, event -> focusLost());
    tree.viewer().getTree().addListener(SWT.Dispose, event -> focusLost());
  }

  /** Activates the keys; may be called repeatedly. */
  public void focusGained() {
    if (active.isEmpty()) {
      commands.forEach(
          (id, action) -> active.add(service.activateHandler(id, new ActionHandler(action))));
    }
  }

  private void focusLost() {
    service.deactivateHandlers(active);
    active.clear();
  }

  /** Fills the context menu of the selection. */
  public void fill(IMenuManager menu) {
    MenuManager children = new MenuManager("New");
    fillNew(children);
    menu.add(children);
    menu.add(new Separator());
    List.of(cut, copy, paste, duplicate, delete).forEach(menu::add);
    menu.add(new Separator());
    List.of(up, down).forEach(menu::add);
  }

  /** Fills the menu of elements that can be created below the selected one or next to it. */
  void fillNew(IMenuManager menu) {
    Object target = target();
    Structure.possible(target).forEach(child -> menu.add(make(target, child)));
    if (target != model.chain()) {
      menu.add(new Separator());
      Structure.possible(model.chain()).forEach(child -> menu.add(make(model.chain(), child)));
    }
  }

  private IAction make(Object target, Structure.Child child) {
    Action action =
        new Action(child.name()) {
          @Override
          public void run() {
            tree.select(structure.make(target, child));
          }
        };
    EObject example = EcoreUtil.create(child.feature().getEReferenceType());
    action.setImageDescriptor(icon(child, example));
    return action;
  }

  private static ImageDescriptor icon(Structure.Child child, EObject example) {
    return switch (child.feature().getName()) {
      case "input" -> Icon.INPUT.descriptor();
      case "output" -> Icon.OUTPUT.descriptor();
      default -> Icon.of(example).descriptor();
    };
  }

  public void fill(IToolBarManager bar) {
    bar.add(new NewMenu(this));
    List.of(delete, up, down).forEach(bar::add);
    bar.update(true);
  }

  private Object target() {
    List<Object> selection = tree.selection();
    return selection.size() == 1 ? selection.get(0) : model.chain();
  }

  private boolean canDelete() {
    List<EObject> elements = tree.elements();
    return !elements.isEmpty() && !elements.contains(model.chain());
  }

  private void delete() {
    Object parent = tree.parent();
    structure.delete(tree.elements());
    if (tree.selection().isEmpty()) {
      tree.select(parent == null ? model.chain() : parent);
    }
  }

  private void cut() {
    Clip.copy(tree.elements());
    delete();
  }

  private void paste() {
    selectAll(Clip.paste(model, target()));
  }

  private void duplicate() {
    Object parent = tree.parent();
    selectAll(Clip.duplicate(model, parent == null ? model.chain() : parent, tree.elements()));
  }

  private void selectAll(List<EObject> elements) {
    if (!elements.isEmpty()) {
      tree.viewer().setSelection(new StructuredSelection(elements), true);
    }
  }

  private boolean canMove(int by) {
    return tree.elements().size() == 1
        && Structure.canMove(tree.parent(), tree.elements().get(0), by);
  }

  private void move(int by) {
    EObject element = tree.elements().get(0);
    structure.move(tree.parent(), element, by);
    tree.select(element);
    update();
  }
}
