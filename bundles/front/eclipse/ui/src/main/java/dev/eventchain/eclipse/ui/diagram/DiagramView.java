package dev.eventchain.eclipse.ui.diagram;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.diagram.ChainDiagram;
import dev.eventchain.model.diagram.ChainLayout;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.xmi.Origins;
import java.util.List;
import org.eclipse.core.resources.IFile;
import org.eclipse.emf.common.notify.Notification;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.util.EContentAdapter;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.ui.part.ViewPart;

/**
 * The view "Event Chain": draws the chain of the active editor or of the selected file, and follows
 * its changes.
 */
public final class DiagramView extends ViewPart
    implements ChainTracker.Listener, DiagramInput.Listener {

  /** Identifier of the view. */
  public static final String ID = "dev.eventchain.eclipse.ui.diagram";

  private DiagramCanvas canvas;
  private MessageBar message;
  private DiagramSelection selection;
  private ChainTracker tracker;
  private ChainLoader loader;
  private FileWatch watch;
  private Later reading;
  private Later marking;
  private Subject subject;
  private EventChain chain;
  private Origins origins = new Origins();
  private Problems problems;

  private final EContentAdapter changes =
      new EContentAdapter() {
        @Override
        public void notifyChanged(Notification notification) {
          super.notifyChanged(notification);
          if (!notification.isTouch()) {
            reading.ask();
          }
        }
      };

  @Override
  public void createPartControl(Composite parent) {
    GridLayout layout = new GridLayout();
    layout.marginWidth = 0;
    layout.marginHeight = 0;
    layout.verticalSpacing = 0;
    parent.setLayout(layout);
    message = new MessageBar(parent);
    canvas = new DiagramCanvas(parent);
    problems = Problems.of(null, canvas.diagram());
    canvas.control().setLayoutData(new GridData(SWT.FILL, SWT.FILL, true, true));
    reading = new Later(canvas.control(), this::read);
    marking = new Later(canvas.control(), this::mark);
    selection = new DiagramSelection(canvas);
    getSite().setSelectionProvider(selection);
    new DiagramInput(canvas, index -> problems.messages(index), this);
    loader = new ChainLoader(result -> reading.inDisplay(() -> loaded(result)));
    watch = new FileWatch(reading::ask, marking::ask, file -> reading.inDisplay(() -> show(file)));
    watch.start();
    tracker = new ChainTracker(getSite().getPage(), this, this);
    new DiagramActions(canvas, tracker::setLinked).fill(getViewSite().getActionBars());
    message.show(MessageBar.INFORMATION, "Select or open an event chain to see it drawn here.");
    tracker.start();
  }

  @Override
  public void dispose() {
    if (tracker != null) {
      tracker.stop();
      watch.stop();
      forget();
    }
    super.dispose();
  }

  @Override
  public void setFocus() {
    canvas.control().setFocus();
  }

  @Override
  public <T> T getAdapter(Class<T> type) {
    if (type == ChainDiagram.class && canvas != null) {
      return type.cast(canvas.diagram());
    } else if (type == Control.class && canvas != null) {
      return type.cast(canvas.control());
    }
    return super.getAdapter(type);
  }

  /** Draws the chain of a file, even if the view is not linked. */
  public void show(IFile file) {
    tracker.turnTo(file);
  }

  @Override
  public void subject(Subject next) {
    boolean isSameFile =
        subject != null && next.file() != null && next.file().equals(subject.file());
    subject = next;
    watch.watch(next.file());
    if (!isSameFile) {
      forget();
      draw(null);
      canvas.zoomToOriginal();
    }
    read();
  }

  @Override
  public void maybeOther() {
    reading.ask();
  }

  @Override
  public void element(EObject element) {
    selection.show(element);
  }

  private void read() {
    if (subject == null) {
      return;
    }
    EventChain edited = subject.chain();
    if (edited != null) {
      show(edited, new Origins());
      if (!edited.eAdapters().contains(changes)) {
        forget();
        chain = edited;
        edited.eAdapters().add(changes);
      }
    } else if (subject.editor() == null && tracker.hasEditor(subject.file())) {
      tracker.turnTo(subject.file()); // its editor can read it now
    } else if (subject.file() != null) {
      loader.load(subject.file());
    } else {
      fail(subject.name() + " has no event chain that can be drawn.");
    }
  }

  private void forget() {
    if (chain != null) {
      chain.eAdapters().remove(changes);
      chain = null;
    }
  }

  private void loaded(ChainLoader.Result result) {
    if (subject == null || !result.file().equals(subject.file()) || subject.chain() != null) {
      return;
    }
    forget();
    if (result.chain() == null) {
      fail(result.problem());
    } else {
      show(result.chain(), result.origins());
    }
  }

  private void show(EventChain shown, Origins places) {
    try {
      origins = places;
      draw(shown);
      boolean isEmpty = canvas.diagram().boxes().isEmpty();
      message.show(MessageBar.INFORMATION, isEmpty ? "The chain has no components yet." : "");
    } catch (RuntimeException e) { // shown to people; a view must not fail
      fail("The picture cannot be drawn: " + e);
    }
  }

  /** Shows a problem; the last diagram stays, but faded as outdated. */
  private void fail(String problem) {
    canvas.fade();
    message.show(MessageBar.ERROR, problem);
  }

  private void draw(EventChain shown) {
    ChainDiagram diagram = new ChainDiagram("", List.of(), List.of(), 0, 0);
    if (shown != null) {
      try (DiagramFonts fonts = new DiagramFonts(canvas.control().getDisplay())) {
        diagram = ChainLayout.of(shown, fonts);
      }
    }
    String path = selection.path();
    Object element = selection.getSelection().getFirstElement();
    ChainDiagram drawn = diagram;
    canvas.show(
        drawn,
        "Event chain " + drawn.name(),
        index -> DiagramTexts.describe(drawn, index, problems.messages(index)));
    setContentDescription(
        drawn.name().isEmpty() ? subject.name() : drawn.name() + " \u2013 " + subject.name());
    mark();
    selection.restore(path, element);
  }

  private void mark() {
    problems = Problems.of(subject == null ? null : subject.file(), canvas.diagram());
    canvas.mark(problems.severities());
  }

  @Override
  public void moved(int box) {
    selection.select(box);
  }

  /** Selects the box and shows its element in the editor, without giving the editor the focus. */
  @Override
  public void clicked(int box) {
    selection.select(box);
    if (box >= 0) {
      open(box, false);
    }
  }

  @Override
  public void opened(int box) {
    open(box, true);
  }

  private void open(int index, boolean activate) {
    if (subject.file() != null) {
      EObject element = canvas.diagram().boxes().get(index).element();
      SourceLocation place = origins.locate(element);
      String problem =
          ElementOpener.open(
              getSite().getPage(), subject.file(), Problems.path(element), place.line(), activate);
      getViewSite()
          .getActionBars()
          .getStatusLineManager()
          .setErrorMessage(problem.isEmpty() ? null : problem);
    }
  }
}
