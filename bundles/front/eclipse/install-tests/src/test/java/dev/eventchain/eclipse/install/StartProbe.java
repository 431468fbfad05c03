package dev.eventchain.eclipse.install;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Dictionary;
import java.util.Hashtable;
import java.util.Map;
import org.osgi.framework.BundleActivator;
import org.osgi.framework.BundleContext;
import org.osgi.service.event.EventConstants;
import org.osgi.service.event.EventHandler;

/**
 * A bundle that writes the contents of the workbench into a file of the workspace once its window
 * is open. It imports nothing of the workbench, so that it fits any version.
 */
public final class StartProbe implements BundleActivator {

  static final String FILE = "shown.xmi";

  /** Event topic that the workbench sends when its window is open. */
  private static final String STARTED = "org/eclipse/e4/ui/LifeCycle/appStartupComplete";

  @SuppressWarnings(
      "JdkObsolete") // OSGi requires a Dictionary, and Hashtable is the only implementation
  @Override
  public void start(BundleContext context) {
    Path workspace = Path.of(URI.create(context.getProperty("osgi.instance.area")));
    Dictionary<String, Object> topics = new Hashtable<>();
    topics.put(EventConstants.EVENT_TOPIC, STARTED);
    EventHandler handler =
        event -> {
          try {
            Path part = workspace.resolve(FILE + ".part");
            Files.write(part, shown(event.getProperty("org.eclipse.e4.data")));
            Files.move(part, workspace.resolve(FILE));
          } catch (IOException e) {
            throw new UncheckedIOException(e);
          }
        };
    context.registerService(EventHandler.class, handler, topics);
  }

  @Override
  public void stop(BundleContext context) {}

  /** Returns the model of the workbench as XMI, or the reason why it is not available. */
  private static byte[] shown(Object application) {
    try {
      Object resource = application.getClass().getMethod("eResource").invoke(application);
      ByteArrayOutputStream out = new ByteArrayOutputStream();
      resource
          .getClass()
          .getMethod("save", OutputStream.class, Map.class)
          .invoke(resource, out, null);
      return out.toByteArray();
    } catch (ReflectiveOperationException | RuntimeException e) {
      return String.valueOf(e).getBytes(StandardCharsets.UTF_8);
    }
  }
}
