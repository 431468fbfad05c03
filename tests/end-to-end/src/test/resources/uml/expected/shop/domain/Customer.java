package domain;

@Entity(table = "CUSTOMERS")
public class Customer implements Named {
    private String name;

    private List<Order> orders;

// Somebody who buys.
}
