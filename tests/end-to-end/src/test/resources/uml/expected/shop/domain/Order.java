package domain;

@Entity(table = "Order")
public class Order extends Item {
    private Customer customer;

    private Integer id; // key

    private Boolean open;

    private State state;

    public Integer total(Integer vat) { }
}
