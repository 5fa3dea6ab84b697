"""Texts that were held out: what each must come to was written down before the reader saw it.

A number in the declared unit, a unit that does not fit, or a question; where several are named,
each is honest. Texts of one outcome stand together, parted by a broken bar.
"""

from dataclasses import replace

import pytest

from gripcourse.course.quantity import Kind
from gripcourse.solver.plan import Plan
from gripcourse.submission.measure import Understood
from gripcourse.submission.raw import CellValue, RawCell
from gripcourse.submission.understand import understand

FORCE = "drive_force"  # in N
BORE = "bore_required"  # in mm
ANGLE = "arm_angle_open"  # in °
RATIO = "velocity_ratio"  # a plain number
PRESSURE = "bearing_stress"  # in MPa
VERDICT = ""  # the first of the plan
ASKED, UNFIT = "asked", "unfit"

TEXTS: tuple[tuple[str, object, str], ...] = (
    (ANGLE, 36.87, "36°52'12\"¦36 ° 52 ' 12 \"¦36,87 °.¦36.87°¦36,87 градуса¦36,87 deg."),
    (ANGLE, 36.86666666666667, "36°52'¦36 градусов 52 минуты¦36° 52′"),
    (ANGLE, 36.0, "36 градусов¦36 degrees¦36 градусів"),
    (
        ANGLE,
        25.5,
        "25 град. 30 мин.¦25 deg 30 min¦25гр30мин¦25 градусів 30 хвилин¦25º30'¦25°30’¦25,5град",
    ),
    (ANGLE, ASKED, "25°30¦25°75'¦π/6¦pi/6¦pi/6 rad¦36;87¦45°±1°¦угол 45¦25-30¦36'52¦минус 5"),
    (ANGLE, 25.3, "25.30°¦25,30 град"),
    (ANGLE, 29.9998, "0,5236 рад¦0.5236rad¦0,5236 радиан"),
    (ANGLE, 29.997, "33.33 gon¦33,33ᵍ"),
    (ANGLE, -5.0, "-5°¦−5°¦– 5 град"),
    (ANGLE, 45.0, "α=45°¦α = 45¦45 °¦45˚"),
    (ANGLE, (36.87, ASKED), "36,87 grad¦36,87 угл. град."),
    (BORE, 0.5, "½¦,5¦.5¦0,5 мм"),
    (
        BORE,
        12.5,
        (
            "12 ½¦12½¦ок 12,5 мм¦ок. 12,5¦приблизительно 12,5¦приблизно 12,5¦~12,5¦≈ 12,5 мм¦"
            "∼12,5¦Ø12,5¦⌀12.5¦d=12,5¦d = 12,5 мм¦１２．５¦«12,5»¦“12,5”¦'12,5'¦12,5 мм.¦12,5мм¦"
            "12,5 MM¦12,5 Мм¦12,5 мм ¦1,25 см¦0,0125 м¦12500 мкм¦12500 µm¦12500 μm¦12.5.¦12,5,¦"
            "12,5;¦12,5 .¦+12,5¦12,5 милиметров¦12,5\u00a0мм¦\u200b12,5¦12,5\n¦12,50 mm.¦"
            "около 12,5 мм¦circa 12,5¦d_b = 12,5¦dб=12,5 мм¦≈12.5mm¦12,5 (мм)¦12,5, мм¦"
            "12.5 millimetres¦12,5 миллиметра¦=12,5"
        ),
    ),
    (BORE, (12.5, ASKED), "D≈12,5¦12, 5¦12 ,5¦(12,5)¦[12,5]¦12,5?¦12,5!¦d 12,5¦12,5 \\мм"),
    (BORE, 12500.0, "12'500¦12 500¦12\u202f500,0¦12.500,0¦12,500.0¦12’500¦12 500 мм"),
    (
        BORE,
        16.0,
        (
            "16 (ГОСТ 6636-69)¦16H7¦16 H7¦16H7/g6¦16h6¦Ø16H7¦16js6¦16 k6¦16 мм (ряд Ra40)¦"
            "16 (по ряду Ra 20)¦16 мм (принято)¦Ø16 H7/k6¦16Н7"
        ),
    ),
    (
        BORE,
        (16.0, ASKED),
        "16 ГОСТ 6636-69¦М16¦R16¦16 принимаем¦принимаем 16¦принято 16 мм¦16 по ГОСТ",
    ),
    (
        BORE,
        ASKED,
        (
            '16х2¦16x2¦16×2¦1"¦1/2"¦12..5¦12,,5¦12,5-¦39ОО¦З9¦l2,5¦О,5¦1О¦12,5О¦I2¦5б¦1 2,5¦'
            "12-1/2¦12,48≈12,5¦2x6,25¦12 мм 5¦12–13¦12..13¦12±0.5¦12+-0,5¦12-13 мм¦от 12¦до 13¦"
            ">12¦≥12¦<13¦не менее 12¦12 (13)¦12/13¦12 или 13¦12 и 13¦?¦-¦—¦нет¦н/д¦x¦нет решения¦"
            "12,5 либо 13¦1) 12,5¦№12¦~¦≈¦=12/5¦12/5¦12:5¦2*6,25¦2·6,25¦5^2¦√2¦sqrt(2)¦22/7¦"
            "=КОРЕНЬ(2)¦12.мар¦12 мар¦мар.12¦12.03.2026¦5-Mar¦12 марта¦12:30¦1 янв¦Jan 5¦05.бер¦"
            "12.бер¦березня 5¦12.05.26¦2026-03-12¦12-мар"
        ),
    ),
    (BORE, (ASKED, UNFIT), "12м5"),
    (BORE, 25.4, "1 inch¦1 дюйм¦1 in¦1in."),
    (BORE, 12.7, "0,5 дюйма¦0.5 in¦1/2 дюйма¦1/2 inch"),
    (
        FORCE,
        1200.0,
        (
            "1.2·10^3¦1,2x10^3¦1,2х10^3¦1,2 × 10³¦1,2*10³ Н¦1,2·10³Н¦1.2e3¦1,2E+03¦1,2Е+3¦12·10²¦"
            "1,2·10^+3¦1.2 * 10 ^ 3 N¦1,2 ∙ 10³ Н¦1,2 kN¦1,2 KN¦1,2 Kn¦1,2 кн¦1,2кН.¦1200 н¦"
            "1200 N.¦1200 Ньютон¦1200 Newton¦1200 newtons¦1,2 килоньютон¦1,2 кілоньютона¦1200 Н.¦"
            "1 200 Н¦1.200,0 Н¦120 daN¦120 даН¦F=1200 Н¦F = 1,2 кН¦Fпр=1200¦1200 кг·м/с²¦"
            "1200 кг*м/с2¦0,0012 МН¦≈1,2 кН¦1200 [Н]¦1200, Н¦1200H¦1200 (Н)"
        ),
    ),
    (
        FORCE,
        (1200.0, ASKED),
        "1,2 10^3¦1200 Н (ньютон)¦1,2 10³¦1200 Н = 1,2 кН¦1,2·10^3 = 1200¦1,2.10^3",
    ),
    (FORCE, 1000.0, "10³¦10^3¦10**3 Н¦1·10^3"),
    (
        FORCE,
        ASKED,
        (
            "1,2*10*3¦1,2·10 3¦1,2·103¦1,2 тыс. Н¦1,2 тысячи¦1,2 тисячі¦1.2 thousand¦1,2 тыс¦"
            "1 200 и 300¦1200/2¦1,2e¦1200-1300 Н¦1,2 млн"
        ),
    ),
    (FORCE, 49.03325, "5,0 кгс¦5 кгс.¦5 kgf¦5 КГС¦5,0 кГс"),
    (
        FORCE,
        UNFIT,
        "1200 Нм¦1200 Н·м¦1200 Н*м¦1200 Н м¦120 кг¦1200 Па¦1200 N/mm2¦1200 Вт¦5 мм¦1200 Н/м",
    ),
    (
        PRESSURE,
        6.3,
        (
            "6,3 Н/мм²¦6,3 Н/мм^2¦6,3 N/mm2¦6,3 МПа.¦6,3 Mpa¦6,3 МПА¦6,3 мПа¦6300 кПа¦6,3 МН/м²¦"
            "6300000 Па¦0,0063 ГПа¦6,3·10^6 Па¦6,3 н/мм2¦6,3 Н / мм2¦6,3 Мпа¦6.3 MPa.¦6,3Н/мм²¦"
            "6,3 N/mm^2"
        ),
    ),
    (PRESSURE, (6.3, ASKED), "6,3 mPa¦6,3 н/мм кв¦6,3 Н на мм2¦6,3 Н/кв.мм¦6,3 МП¦6,3 мегапаскаль"),
    (PRESSURE, 6.17829, "63 кгс/см2¦63 кгс/см²¦63 kgf/cm2¦0,63 кгс/мм2"),
    (PRESSURE, 6.383475, "63 атм"),
    (PRESSURE, 6.294913, "913 psi"),
    (
        VERDICT,
        1.0,
        (
            "да.¦так¦ТАК¦Да¦да!¦ да ¦yes.¦YES¦True¦истина¦+¦1¦Да (выполняется)¦да, выполняется¦"
            '"да"¦✓¦ДА¦Yes, it holds¦так, виконується'
        ),
    ),
    (
        VERDICT,
        0.0,
        (
            "нет (не проходит)¦нет.¦Нет!¦НЕТ¦no.¦ні.¦Ні¦ЛОЖЬ¦false¦0¦-¦нет, не выполняется¦"
            "No (fails)¦✗"
        ),
    ),
    (VERDICT, (ASKED, 1.0), "ok¦выполняется¦подходит¦тaк¦д¦y¦виконується¦проходит¦√"),
    (VERDICT, (ASKED, 0.0), "не выполняется¦не подходит¦не проходит¦n¦н¦не¦не виконується¦fails"),
    (
        VERDICT,
        ASKED,
        (
            "да нет¦да/нет¦yes/no¦не знаю¦2¦может быть¦да, но нет¦нет, да¦?¦да или нет¦-1¦"
            "да? нет¦да, не выполняется¦нет, выполняется¦нет, но да¦да (если округлить)¦"
            "да, или нет¦так, ні"
        ),
    ),
    (RATIO, 0.3333333333333333, "1/3"),
    (RATIO, 0.85, "85%¦85 %¦0,85¦85,0 %¦85 процентов¦85 відсотків¦85 percent¦85%."),
    (BORE, UNFIT, "85%¦85 %"),
    (RATIO, 2.5, "i = 2,5¦u=2,5¦2,5 раз¦2,5 раза¦2,5 (безразмерная)¦2,5 б/р¦i=2,50"),
    (RATIO, ASKED, "2,5:1¦1:2,5¦2,5 -¦2,5 к 1"),
    (FORCE, (ASKED, UNFIT), "1,2k¦1,2к"),
    (BORE, (UNFIT, 12.5, ASKED), "12,5 м м"),
)

SHOWN: tuple[tuple[str, CellValue, str, object], ...] = (
    (VERDICT, True, "General", 1.0),
    (VERDICT, 1, "General", 1.0),
    (VERDICT, 1.0, "General", 1.0),
    (VERDICT, False, "General", 0.0),
    (VERDICT, 0, "General", 0.0),
    (VERDICT, 0.0, "General", 0.0),
    (FORCE, 1.2, '0.0" кН"', 1200.0),
    (ANGLE, 36.9, '0.0"°"', 36.9),
    (BORE, 1.25, '0.00" см"', 12.5),
    (BORE, 12.5, "0.0\\ \\м\\м", 12.5),
    (BORE, 12.5, '0.0" мм"', 12.5),
    (BORE, 0.5, "# ?/?", 0.5),
    (BORE, 12.5, "[Red]0.0", 12.5),
    (FORCE, 1200, '#,##0.0" Н"', 1200.0),
    (FORCE, 5, '0.0"кгс"', 49.03325),
    (BORE, 12.5, 'General" mm"', 12.5),
    (PRESSURE, 6.3, '0.0 "MPa"', 6.3),
    (FORCE, 1200, '0.0" Н·м"', UNFIT),
    (FORCE, 1.2, '0.0\\ "kN"', 1200.0),
    (BORE, 12.5, '0.0" (принято)"', 12.5),
    (FORCE, 1200.0, "0.00E+00", 1200.0),
    (ANGLE, 0.5, '0.00" рад"', 28.6479),
    (BORE, 12.5, '"≈"0.0', 12.5),
    (BORE, 12.5, '"Ø"0.0', 12.5),
    (FORCE, 1200, '0.0" Н";-0.0" Н"', 1200.0),
    (RATIO, 0.85, "0%", 0.85),
    (BORE, True, "General", ASKED),
)


def _came_to(quantity: str, stored: CellValue, number_format: str, plan: Plan) -> object:
    asked = plan.quantities.get(quantity) or next(
        one for one in plan.answered if one.kind is Kind.VERDICT
    )
    found = understand(asked, RawCell(stored, number_format, False, "", "x!E6"))
    if not isinstance(found, Understood):
        return ASKED
    return found.value if found.unit_fits else UNFIT


def _is_one_of(came_to: object, allowed: object) -> bool:
    outcomes = allowed if isinstance(allowed, tuple) else (allowed,)
    return any(
        came_to == pytest.approx(one, rel=2e-5) if isinstance(one, float) else came_to == one
        for one in outcomes
    )


def test_what_was_held_out_is_read_or_asked_about_and_never_guessed(plan: Plan) -> None:
    otherwise = {
        (quantity, text): came_to
        for quantity, allowed, texts in TEXTS
        for text in texts.split("¦")
        if not _is_one_of(came_to := _came_to(quantity, text, "@", plan), allowed)
    }
    assert otherwise == {}


def test_a_number_means_what_its_format_shows(plan: Plan) -> None:
    otherwise = {
        (quantity, stored, shown): came_to
        for quantity, stored, shown, allowed in SHOWN
        if not _is_one_of(came_to := _came_to(quantity, stored, shown, plan), allowed)
    }
    assert otherwise == {}


OTHER_UNITS: tuple[tuple[str, object, str], ...] = (
    ("N*m", 1.2, "1,2 Н·м¦1200 Н·мм¦1,2 Нм¦1.2 N m¦1,2 Дж¦0,0012 кН·м¦1.2 N⋅m¦1,2 ньютон-метра"),
    ("N*m", 1.1768, "12 кгс·см"),
    ("N*m", UNFIT, "1,2 Н/м¦1,2 Н"),
    ("mm/s", 250.0, "0,25 м/с¦15 м/мин¦25 см/с¦0.25 m/s¦0,25 м/сек¦250 мм/сек.¦0,25 м·с⁻¹"),
    ("mm/s", ASKED, "0,25…0,30 м/с¦250-"),
    ("kW", 0.25, "250 Вт¦0,25 кВт¦0.25 kW¦250 W¦0,25 kВт"),
    ("rpm", 1500.0, "1500 об/мин¦1500 rpm¦25 об/с¦1500 мин⁻¹¦1500 min^-1¦25 Гц"),
    ("rpm", 1500.0, "157,0796 рад/с¦1500 об/хв¦1500 r/min¦1500 об./мин"),
    ("rpm", ASKED, "25 с⁻¹¦25 s^-1¦1500 1/мин"),
    ("mm**2", 78.54, "78,54 мм²¦0,7854 см²¦78,54 мм^2¦78,54 кв. мм¦7,854·10⁻⁵ м²¦7.854e-5 m2"),
    ("mm**2", UNFIT, "78,54 мм³¦78,54 мм"),
    ("N", -350.0, "-350 Н¦−350 Н¦- 350¦–350¦‑350"),
    ("N", ASKED, "12,500.000.0¦1.25.00¦12-500¦€12500¦350 Н ± 5 %¦(350;360)¦350 … 360"),
    ("deg", -12.5, "-12°30'¦−12° 30′¦- 12 град 30 мин"),
    ("deg", ASKED, "36,52'¦36°52'72\"¦36° -12'¦52'"),
    ("", 1.75, "1 ¾¦1¾"),
    ("", ASKED, "3/0¦1/3/5¦3:4¦√3/2¦sin 30"),
    ("", 0.001, "10⁻³¦10^-3¦1·10⁻³¦1*10^(-3)"),
)


def test_other_units_are_read_or_asked_about_and_never_guessed(plan: Plan) -> None:
    otherwise = {}
    for unit, allowed, texts in OTHER_UNITS:
        asked = replace(plan.quantities[FORCE], unit=unit)
        own = replace(plan, quantities={**plan.quantities, FORCE: asked})
        for text in texts.split("¦"):
            came_to = _came_to(FORCE, text, "@", own)
            if not _is_one_of(came_to, allowed):
                otherwise[unit, text] = came_to
    assert otherwise == {}
